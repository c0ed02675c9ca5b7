#include "solid/heaviside.hpp"

#include <cmath>
#include <numbers>

namespace washtub {
namespace {

constexpr double almost_closed = 1e-3;  // open fraction too small for a pressure gradient to act on

}  // namespace

float Heaviside::open_fraction(double psi) const {
  if (psi > gamma) return 0;
  if (psi <= -gamma) return 1;
  const double s = psi / gamma;
  const double pi = std::numbers::pi;
  const double open = 0.5 - 0.5 * (s + std::sin(pi * s) / pi);
  return open < almost_closed ? 0.0F : static_cast<float>(open);
}

}  // namespace washtub
