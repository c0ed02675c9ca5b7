#pragma once

namespace washtub {

/// What the pressures of the last two steps are worth. A face that opens or closes at once kicks
/// the pressure by O(1/dt), and then an extrapolated pressure is worse than none; so do the start,
/// whose pressure holds an impulse, and, where the next velocity is concerned, a force.
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
  /// Whether the force of this step is not zero everywhere.
  void set_forced(bool forced) { forced_ = forced; }

  /// Of this step's pressure: extrapolated after three steps without a flip, kept after two.
  Guess guess() const {
    if (steps_ >= 3) return {2, -1};
    return {steps_ == 2 ? 1.0 : 0.0, 0};
  }
  /// Whether the last pressure gradient will about go on in the next step.
  bool gradient_holds() const { return steps_ >= 1 && !forced_; }

 private:
  int steps_ = -1;  ///< since a flip
  bool forced_ = false;
};

}  // namespace washtub
