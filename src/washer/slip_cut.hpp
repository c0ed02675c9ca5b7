#pragma once
#include <algorithm>

#include "base/archive.hpp"

namespace washtub {

/// Cuts the time step where cloth slips past the water more than a part of the largest speed, and
/// lets it go again where a shorter step does not help: layers of cloth much nearer to each other
/// than a cell slip whatever the step, since the water does not tell them apart.
class SlipCut {
 public:
  double factor() const { return factor_; }

  /// @param slip  rms over the largest speed
  void look(double slip) {
    if (pause_ > 0 || slip <= limit) {
      pause_ = std::max(0, pause_ - 1);
      factor_ = std::min(1.0, regain * factor_);
      return;
    }
    if (factor_ == 1) before_ = slip;
    const bool no_help = factor_ <= 0.5 && slip > helps * before_;
    if (no_help || factor_ <= least)
      pause_ = patience;
    else
      factor_ = std::max(least, 0.7 * factor_);
  }

  void state(Archive& archive) {
    archive.value("factor", factor_);
    archive.value("before", before_);
    archive.value("pause", pause_);
  }

 private:
  static constexpr double limit = 0.05;
  static constexpr double least = 0.1;    // of the factor
  static constexpr double regain = 1.17;  // of the factor, at each look
  static constexpr double helps = 0.8;    // of the slip before, at half the step
  static constexpr int patience = 125;    // looks without a cut

  double factor_ = 1;
  double before_ = 0;  ///< slip when the step was whole
  int pause_ = 0;      ///< looks that are left without a cut
};

}  // namespace washtub
