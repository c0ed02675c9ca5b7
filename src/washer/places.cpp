#include "washer/places.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>

namespace washtub {
namespace {

template <int D>
std::string at(const Vec<D>& x) {
  std::vector<std::string> parts;
  for (int d = 0; d < D; ++d) parts.push_back(fmt::format("{:.3g}", x[d]));
  return fmt::format("at ({}) m", fmt::join(parts, ", "));
}

/// Nodes are counted from 0 along r and s, pieces from 1, as for probes.
template <int D>
std::string node_name(const ClothGroup<D>& group, int piece, int node) {
  const int i = node % group.sheet.extent[0], j = node / group.sheet.extent[0];
  const int number = group.first_piece + piece + 1;
  return D == 3 ? fmt::format("node ({}, {}) of piece {}", i, j, number)
                : fmt::format("node {} of piece {}", j, number);
}

/// Calls visit(group, piece, node of the piece) for all nodes.
template <int D, class Visit>
void for_nodes(const Cloth<D>& cloth, Visit&& visit) {
  for (const auto& group : cloth.groups)
    for (int p = 0; p < group.pieces; ++p)
      for (int n = 0; n < group.sheet.nodes(); ++n) visit(group, p, n);
}

/// The face or cell of all ranks with the largest value, and the value.
template <int D>
struct Spot {
  double value = -1;
  Vec<D> x = Vec<D>::Zero();

  void take(double candidate, const Vec<D>& where) {
    if (candidate > value) value = candidate, x = where;
  }
  void agree(const Parallel& parallel) {
    const double largest = parallel.max(value);
    const double first = -parallel.max(value == largest ? -parallel.rank() : -parallel.size());
    if (first != parallel.rank()) x.setZero();
    parallel.sum(std::span<double>(x.data(), D));
    value = largest;
  }
};

/// The spot of the largest value(u) over the faces along axis d of all ranks (d = -1: over the
/// cells) of a field.
template <int D, class Value>
Spot<D> find_spot(const Grid<D>& grid, const Field& field, int d, Value&& value) {
  const auto& block = grid.block();
  Spot<D> spot;
  Index<D> cell{};
  for (int k = 0; k < block.planes(); ++k)
    for (int j = 0; j < block.rows(); ++j)
      for (int i = 0; i < block.width(); ++i) {
        cell[0] = i;
        if constexpr (D == 3) cell[1] = j;
        cell[D - 1] = k;
        const double v = value(field[block.at(cell)]);
        if (v > spot.value) spot.take(v, grid.position(cell, d));
      }
  return spot;
}

}  // namespace

template <int D>
std::string place_of_largest_speed(const Flow<D>& flow) {
  Spot<D> fastest;
  for (int d = 0; d < D; ++d) {
    const Spot<D> spot =
        find_spot(flow.grid(), flow.velocity()[d], d, [](double u) { return std::abs(u); });
    fastest.take(spot.value, spot.x);
  }
  fastest.agree(flow.grid().parallel());
  return at<D>(fastest.x);
}

template <int D>
std::string not_finite(const Flow<D>& flow, const Cloth<D>& cloth) {
  std::string place;
  for_nodes(cloth, [&](const ClothGroup<D>& group, int piece, int node) {
    const auto& x = cloth.piece(group, piece)[static_cast<std::size_t>(node)];
    if (place.empty() && !x.allFinite()) place = "the cloth, at " + node_name(group, piece, node);
  });
  if (!place.empty()) return place;
  const auto& grid = flow.grid();
  const auto look = [&](const char* what, const Field& field, int d) {
    auto spot = find_spot(grid, field, d, [](double v) { return std::isfinite(v) ? 0.0 : 1.0; });
    spot.agree(grid.parallel());
    if (place.empty() && spot.value > 0) place = fmt::format("{}, {}", what, at<D>(spot.x));
  };
  for (int d = 0; d < D; ++d) look("the velocity", flow.velocity()[d], d);
  look("the pressure", flow.pressure(), -1);
  return place;
}

template std::string place_of_largest_speed<2>(const Flow<2>&);
template std::string place_of_largest_speed<3>(const Flow<3>&);
template std::string not_finite<2>(const Flow<2>&, const Cloth<2>&);
template std::string not_finite<3>(const Flow<3>&, const Cloth<3>&);

}  // namespace washtub
