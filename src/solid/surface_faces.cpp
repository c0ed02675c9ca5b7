#include "solid/surface_faces.hpp"

#include <algorithm>

namespace washtub {

template <int D>
SurfaceFace<D> SurfaceFaces<D>::face(const Index<D>& cell) const {
  const auto& block = grid_.block();
  std::uint8_t edges = 0;
  for (int d = 0; d < D; ++d) {
    const int first = d == axis_ ? 1 : 0, last = block.count[d] - 1;
    if (!(cell[d] == first && grid_.at_side(d, 0))) edges |= 1 << (2 * d);
    if (!(cell[d] == last && grid_.at_side(d, 1))) edges |= 2 << (2 * d);
  }
  return {block.at(cell), grid_.position(cell, axis_), edges};
}

template <int D>
void SurfaceFaces<D>::update(const float* open) {
  const auto before = [](const auto& a, const auto& b) { return a.p < b.p; };
  if (released_) std::erase_if(faces_, [&](const auto& face) { return open[face.p] >= 1; });
  released_ = false;
  if (added_.empty()) return;
  std::sort(added_.begin(), added_.end(), before);
  merged_.resize(faces_.size() + added_.size());
  std::merge(faces_.begin(), faces_.end(), added_.begin(), added_.end(), merged_.begin(), before);
  faces_.swap(merged_);
  added_.clear();
}

template class SurfaceFaces<2>;
template class SurfaceFaces<3>;

}  // namespace washtub
