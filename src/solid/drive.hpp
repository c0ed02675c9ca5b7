#pragma once
#include <memory>
#include <vector>

namespace washtub {

/// Prescribed rotation about z: speed omega(t) and the angle it has swept since t = 0, t >= 0.
class Drive {
 public:
  struct Law;  // one kind of drive
  explicit Drive(std::shared_ptr<const Law> law) : law_(std::move(law)) {}

  double speed(double t) const;  ///< omega [rad/s]
  double angle(double t) const;  ///< exact integral of the speed from 0 to t [rad]
  double peak() const;           ///< largest |omega| [rad/s]
  double period() const;         ///< [s]; 0 where the drive has none
  bool moving() const { return peak() > 0; }

 private:
  std::shared_ptr<const Law> law_;
};

// Every maker throws an InputError that names the parameter where it is out of range.

Drive at_rest();
Drive constant_speed(double omega);
/// omega = peak sin(2 pi frequency t), Eq. (16); frequency [Hz] > 0.
Drive sinusoid(double peak, double frequency);
/// Linear between (time [s], speed [rad/s]) points; starts again after the last one when `repeat`,
/// else holds it. At least two points, times increasing from 0.
Drive stroke_table(const std::vector<double>& times, const std::vector<double>& speeds,
                   bool repeat);

}  // namespace washtub
