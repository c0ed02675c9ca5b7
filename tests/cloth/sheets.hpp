#pragma once
#include <cmath>
#include <numbers>
#include <random>
#include <vector>

#include "cloth/plate.hpp"
#include "cloth/thread.hpp"

namespace washtub::testing {

/// A thread and plates of moderate stiffness, so that every part of the energy counts.
inline Sheet<2> thread() { return make_thread(9, 0.1, {50, 0, 0.3, 0, 0, 0, 1e-3}); }
inline Sheet<3> plate(double poisson) {
  return make_plate({5, 4}, {0.1, 0.13}, {50, 20, 0.3, 0.2, poisson, 0, 1e-3});
}

/// Closed ones: going on for ever, rolled up to a ring, and to a tube along s.
inline Sheet<2> periodic_thread() {
  return make_thread(9, 0.1, {50, 0, 0.3, 0, 0, 0, 1e-3}, true, {0.9, 0});
}
inline Sheet<3> periodic_plate(double poisson) {
  return make_plate({5, 4}, {0.1, 0.13}, {50, 20, 0.3, 0.2, poisson, 0, 1e-3}, {true, true},
                    {Vec<3>(0.5, 0, 0), Vec<3>(0, 0.52, 0)});
}
inline Sheet<2> ring() { return make_thread(9, 0.1, {50, 0, 0.3, 0, 0, 0, 1e-3}, true); }
inline Sheet<3> tube(double poisson) {
  return make_plate({5, 7}, {0.1, 0.13}, {50, 20, 0.3, 0.2, poisson, 0, 1e-3}, {false, true});
}

/// Radius of the circle through n nodes a distance ds apart.
inline double circle_radius(int n, double ds) { return ds / (2 * std::sin(std::numbers::pi / n)); }

/// The sheet with all edges at their rest length, flat: X = (r, s, 0), or (s, 0) in 2-D; rings and
/// tubes rolled up about the origin or the x-axis.
template <int D>
std::vector<Vec<D>> flat(const Sheet<D>& sheet) {
  std::vector<Vec<D>> X(sheet.nodes(), Vec<D>::Zero());
  for (int j = 0; j < sheet.extent[1]; ++j) {
    for (int i = 0; i < sheet.extent[0]; ++i) {
      Vec<D>& x = X[sheet.node(i, j)];
      x[D - 2] = j * sheet.spacing[1];
      if (sheet.closed[1] && sheet.period[1].isZero(0)) {
        const double angle = 2 * std::numbers::pi * j / sheet.extent[1];
        const double R = circle_radius(sheet.extent[1], sheet.spacing[1]);
        x[D - 2] = R * std::cos(angle);
        x[D - 1] = R * std::sin(angle);
      }
      x[0] += D == 3 ? i * sheet.spacing[0] : 0;
    }
  }
  return X;
}

/// The flat sheet with every component displaced at random by about `size` [m].
template <int D>
std::vector<Vec<D>> shaken(const Sheet<D>& sheet, double size, unsigned seed = 1) {
  std::mt19937 random(seed);
  std::normal_distribution<double> normal(0, size);
  auto X = flat(sheet);
  for (auto& x : X)
    for (int c = 0; c < D; ++c) x[c] += normal(random);
  return X;
}

}  // namespace washtub::testing
