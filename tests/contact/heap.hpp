#pragma once
#include <random>

#include "cloth/plate.hpp"
#include "cloth/thread.hpp"
#include "contact/contact.hpp"
#include "support/dots.hpp"

namespace washtub::testing {

/// A box without periodic sides, large enough for any heap.
template <int D>
Mesh<D> open_box() {
  Mesh<D> mesh;
  mesh.lower = Vec<D>::Constant(-10);
  mesh.h = Vec<D>::Constant(1);
  mesh.cells.fill(20);
  return mesh;
}

/// Flat pieces one above the other, `apart` from each other, each turned at random in its plane.
inline Cloth<3> heap_of_plates(int pieces, double apart) {
  const auto sheet = make_plate({4, 5}, {0.1, 0.1}, {100, 10, 1e-3, 1e-3, 0, 0, 1e-3});
  std::mt19937 random(3);
  std::uniform_real_distribution<double> turn(0, 6.28);
  std::vector<Vec<3>> where;
  for (int p = 0; p < pieces; ++p) {
    const double c = std::cos(turn(random)), s = std::sqrt(1 - c * c);
    for (int n = 0; n < sheet.nodes(); ++n) {
      const double x = 0.1 * (n % 4) - 0.15, y = 0.1 * (n / 4) - 0.2;
      where.emplace_back(c * x - s * y, s * x + c * y, apart * p);
    }
  }
  Cloth<3> cloth;
  cloth.add(sheet, where);
  return cloth;
}

inline Cloth<2> heap_of_threads(int pieces, double apart) {
  std::vector<Vec<2>> where;
  for (int p = 0; p < pieces; ++p)
    for (int n = 0; n < 6; ++n) where.emplace_back(0.1 * n + 0.03 * p, apart * p);
  Cloth<2> cloth;
  cloth.add(make_thread(6, 0.1, {100, 0, 1e-3, 0, 0, 0, 1e-3}), where);
  return cloth;
}

template <int D>
Cloth<D> heap(int pieces, double apart) {
  if constexpr (D == 3)
    return heap_of_plates(pieces, apart);
  else
    return heap_of_threads(pieces, apart);
}

/// Each component up to `size` either way.
template <int D>
std::vector<Vec<D>> random_ways(std::size_t count, double size, std::uint64_t seed) {
  std::vector<Vec<D>> ways(count);
  for (std::size_t i = 0; i < count; ++i)
    for (int d = 0; d < D; ++d)
      ways[i][d] = size * scatter(1000 * seed + 10 * i + static_cast<std::uint64_t>(d));
  return ways;
}

/// The least distance of any two parts without a common node, by looking at all of them.
template <int D>
double least_gap(const ClothSurface<D>& surface, const std::vector<Vec<D>>& x) {
  double least = 1e30;
  const auto look = [&](const Pair<D>& pair) {
    for (std::size_t a = 0; a < Pair<D>::points; ++a)
      for (std::size_t b = 0; b < a; ++b)
        if (pair.point[a] == pair.point[b]) return;
    least = std::min(least, nearest<D>(pair.split, pair.places(x)).gap.norm());
  };
  for (int i = 0; i < surface.points(); ++i)
    for (const auto& face : surface.faces) {
      Pair<D> pair{{i}, 1, Vec<D>::Zero()};
      std::copy(face.begin(), face.end(), pair.point.begin() + 1);
      look(pair);
    }
  if constexpr (D == 3)
    for (const auto& a : surface.edges)
      for (const auto& b : surface.edges) look({{a[0], a[1], b[0], b[1]}, 2, Vec<3>::Zero()});
  return least;
}

}  // namespace washtub::testing
