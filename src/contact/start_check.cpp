#include "contact/start_check.hpp"

#include "cloth/crossings.hpp"
#include "contact/pair_list.hpp"

namespace washtub {

template <int D>
std::optional<TooNear> find_too_near(const Cloth<D>& cloth, const Mesh<D>& mesh, double gap) {
  if (const Crossings found = find_crossings(cloth, mesh); !found.pieces.empty())
    return TooNear{(*found.pieces.begin())[0], (*found.pieces.begin())[1], 0};
  const ClothSurface<D> surface(cloth);
  std::vector<Vec<D>> x;
  if (!surface.place(cloth.position, x)) return std::nullopt;
  PairList<D> list(surface, mesh, 0);
  list.cover(x, x, gap);
  std::optional<TooNear> nearest_pair;
  for (const auto& pair : list.pairs()) {
    const double d = nearest<D>(pair.split, pair.places(x)).gap.norm();
    if (d >= (nearest_pair ? nearest_pair->distance : gap)) continue;
    nearest_pair = {surface.piece[pair.point.front()], surface.piece[pair.point.back()], d};
  }
  return nearest_pair;
}

template std::optional<TooNear> find_too_near(const Cloth<2>&, const Mesh<2>&, double);
template std::optional<TooNear> find_too_near(const Cloth<3>&, const Mesh<3>&, double);

}  // namespace washtub
