#include "solid/solid.hpp"

#include <cmath>

namespace washtub {

SolidPose::SolidPose(const Shape& shape, const Vec<3>& centre, double angle, double speed)
    : shape_(&shape),
      centre_(centre),
      cos_(std::cos(angle)),
      sin_(std::sin(angle)),
      speed_(speed) {}

double SolidPose::psi(const Vec<3>& x) const {
  const Vec<3> d = x - centre_;
  return shape_->psi({cos_ * d[0] + sin_ * d[1], cos_ * d[1] - sin_ * d[0], d[2]});
}

Vec<3> SolidPose::normal(const Vec<3>& x, double step) const {
  Vec<3> gradient;
  for (int k = 0; k < 3; ++k) {
    const Vec<3> e = step * Vec<3>::Unit(k);
    gradient[k] = psi(x + e) - psi(x - e);
  }
  const double size = gradient.norm();
  return size > 1e-6 * step ? Vec<3>(gradient / size) : Vec<3>::Zero();
}

Vec<3> SolidPose::normal(const Vec<3>& x, double psi, double step) const {
  Vec<3> gradient;
  for (int k = 0; k < 3; ++k) gradient[k] = this->psi(x + step * Vec<3>::Unit(k)) - psi;
  const double size = gradient.norm();
  return size > 1e-6 * step ? Vec<3>(gradient / size) : Vec<3>::Zero();
}

SolidPose Solid::at(double t) const { return {shape, centre, drive.angle(t), drive.speed(t)}; }

double Solid::psi(const Vec<3>& x, double t) const { return at(t).psi(x); }

Vec<3> Solid::velocity(const Vec<3>& x, double t) const { return at(t).velocity(x); }

Vec<3> Solid::normal(const Vec<3>& x, double t, double step) const { return at(t).normal(x, step); }

}  // namespace washtub
