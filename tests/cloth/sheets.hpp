#pragma once
#include <cmath>
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

/// The sheet at rest, flat: X = (r, s, 0), or (s, 0) in 2-D.
template <int D>
std::vector<Vec<D>> flat(const Sheet<D>& sheet) {
  std::vector<Vec<D>> X(sheet.nodes(), Vec<D>::Zero());
  for (int j = 0; j < sheet.extent[1]; ++j) {
    for (int i = 0; i < sheet.extent[0]; ++i) {
      X[sheet.node(i, j)][D - 2] = j * sheet.spacing[1];
      X[sheet.node(i, j)][0] += D == 3 ? i * sheet.spacing[0] : 0;
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
