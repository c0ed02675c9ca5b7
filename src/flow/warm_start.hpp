#pragma once
#include "base/archive.hpp"

namespace washtub {

/// What the pressures of the last two steps are worth. A face that opens or closes at once kicks
/// the pressure by O(1/dt), and then an extrapolated one is worse than none. The start counts as
/// such a flip, since its pressure holds an impulse.
class WarmStart {
 public:
  /// First guess of a pressure: last p + before p_before.
  struct Guess {
    double last = 0, before = 0;
  };

  /// A face has opened or closed at once since the last step.
  void flip() { steps_ = -1; }
  /// To be called once a step, before its projection.
  void next_step() { ++steps_; }

  /// Of this step's pressure: extrapolated after three steps without a flip, kept after two.
  Guess guess() const {
    if (steps_ >= 3) return {2, -1};
    return {steps_ == 2 ? 1.0 : 0.0, 0};
  }
  /// Whether the force of this step is not zero everywhere.
  void set_forced(bool forced) { forced_ = forced; }
  /// Whether the next step may count on the last pressure gradient: no flip for two steps, and no
  /// force, which the gradient would have to follow.
  bool gradient_holds() const { return steps_ >= 1 && !forced_; }

  void state(Archive& archive) {
    archive.value("steps", steps_);
    archive.value("forced", forced_);
  }

 private:
  int steps_ = -1;  ///< since a flip
  bool forced_ = false;
};

}  // namespace washtub
