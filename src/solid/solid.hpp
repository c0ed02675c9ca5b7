#pragma once
#include <string>

#include "solid/drive.hpp"
#include "solid/shape.hpp"

namespace washtub {

/// A solid at one instant: its angle is worked out once, for loops over many points.
/// Valid while the Solid it came from lives.
class SolidPose {
 public:
  SolidPose(const Shape& shape, const Vec<3>& centre, double angle, double speed);

  double psi(const Vec<3>& x) const;  ///< signed distance [m], > 0 inside
  /// Of the solid's matter at x [m/s].
  Vec<3> velocity(const Vec<3>& x) const {
    return {-speed_ * (x[1] - centre_[1]), speed_ * (x[0] - centre_[0]), 0.0};
  }
  /// Unit vector along grad psi (into the solid), by central differences over `step` [m];
  /// zero where the differences vanish, as at the centre of a sphere.
  Vec<3> normal(const Vec<3>& x, double step) const;
  /// The same by one-sided differences from psi at x, at half the price.
  Vec<3> normal(const Vec<3>& x, double psi, double step) const;

 private:
  const Shape* shape_;
  Vec<3> centre_;
  double cos_, sin_, speed_;
};

/// A rigid solid: a shape that turns about the vertical through `centre` as its drive says.
struct Solid {
  std::string name;
  Shape shape;    ///< in the body frame, axis at the origin
  Vec<3> centre;  ///< [m]
  Drive drive;
  std::size_t body = 0;  ///< which of the solids of a case this is, or is an image of

  /// The solid frozen at time t; prefer it to the three below in loops.
  SolidPose at(double t) const;
  /// Signed distance at time t [m], > 0 inside.
  double psi(const Vec<3>& x, double t) const;
  /// Velocity u_o of the solid's matter at x [m/s], Eq. (9).
  Vec<3> velocity(const Vec<3>& x, double t) const;
  /// Unit vector along grad psi (into the solid), by central differences over `step` [m].
  Vec<3> normal(const Vec<3>& x, double t, double step) const;
};

}  // namespace washtub
