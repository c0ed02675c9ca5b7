#include "contact/neighbours.hpp"

#include <algorithm>

#include "cloth/boxes.hpp"
#include "cloth/surface.hpp"
#include "contact/pair_list.hpp"

namespace washtub {
namespace {

constexpr double apart = 1.5;  // of the reach: nearer parts of one piece are not two

template <int D>
bool are_two_parts(const ClothSurface<D>& surface, const Pair<D>& pair, double reach) {
  const int piece = surface.piece[static_cast<std::size_t>(pair.point.front())];
  const auto split = pair.point.begin() + pair.split;
  for (auto a = pair.point.begin(); a != split; ++a)
    for (auto b = split; b != pair.point.end(); ++b)
      if (surface.rest_distance(piece, surface.rest[static_cast<std::size_t>(*a)],
                                surface.rest[static_cast<std::size_t>(*b)]) <= apart * reach)
        return false;
  return true;
}

template <int D>
void find_gaps(const ClothSurface<D>& surface, const std::vector<Vec<D>>& x, const Mesh<D>& mesh,
               double reach, Neighbours& found) {
  PairList<D> list(surface, mesh, 0);
  list.cover(x, x, reach);
  for (const Pair<D>& pair : list.pairs()) {
    const auto piece = [&](int point) { return surface.piece[static_cast<std::size_t>(point)]; };
    const bool own = piece(pair.point.front()) == piece(pair.point.back());
    double& gap = own ? found.own_gap : found.gap;
    if (own && !are_two_parts(surface, pair, reach)) continue;
    gap = std::min(gap, nearest<D>(pair.split, pair.places(x)).gap.norm());
  }
}

template <int D>
void find_nodes(const ClothSurface<D>& surface, const std::vector<Vec<D>>& X, const Mesh<D>& mesh,
                double reach, Neighbours& found) {
  std::vector<BoundingBox<D>> places;
  for (const Vec<D>& x : X) places.push_back({x, x});
  const BoxLists<D> lists(places, mesh, 2 * reach);
  for (std::size_t i = 0; i < X.size(); ++i) {
    const Vec<D> far = Vec<D>::Constant(reach);
    lists.for_overlaps({X[i] - far, X[i] + far}, [&](std::size_t j, const Vec<D>& shift) {
      if (j <= i || surface.piece[i] == surface.piece[j]) return;
      if ((X[i] + shift - X[j]).norm() < reach)
        found.nodes.emplace_back(static_cast<int>(i), static_cast<int>(j));
    });
  }
  std::sort(found.nodes.begin(), found.nodes.end());
}

}  // namespace

template <int D>
Neighbours find_neighbours(const Cloth<D>& cloth, const Mesh<D>& mesh, double reach) {
  Neighbours found;
  const ClothSurface<D> surface(cloth);
  std::vector<Vec<D>> x;
  if (!surface.place(cloth.position, x)) return found;
  find_gaps(surface, x, mesh, reach, found);
  find_nodes(surface, cloth.position, mesh, reach, found);
  return found;
}

template Neighbours find_neighbours(const Cloth<2>&, const Mesh<2>&, double);
template Neighbours find_neighbours(const Cloth<3>&, const Mesh<3>&, double);

}  // namespace washtub
