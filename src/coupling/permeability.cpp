#include "coupling/permeability.hpp"

#include <algorithm>

#include "cloth/face_normal.hpp"

namespace washtub {

template <int D>
Permeability<D>::Permeability(const Cloth<D>& cloth, const ClothSurface<D>& surface)
    : surface_(surface) {
  for (const auto& g : cloth.groups)
    for (int p = 0; p < g.pieces; ++p)
      for (const double area : g.sheet.area)
        over_area_.push_back(g.sheet.material.permeability / area);
  if (std::all_of(over_area_.begin(), over_area_.end(), [](double p) { return p == 0; }))
    over_area_.clear();
  through_.assign(over_area_.size(), Mat<D>::Zero());
}

template <int D>
void Permeability<D>::find(const std::vector<Vec<D>>& X) {
  if (!any() || !surface_.place(X, points_)) return;
  normal_.assign(X.size(), Vec<D>::Zero());
  for (const auto& face : surface_.faces) {
    const Vec<D> normal = face_normal<D>(face, points_);
    for (const int point : face)
      normal_[static_cast<std::size_t>(surface_.node[static_cast<std::size_t>(point)])] += normal;
  }
  for (std::size_t i = 0; i < through_.size(); ++i) {
    const double squares = normal_[i].squaredNorm();
    through_[i] = squares > 0
                      ? Mat<D>(over_area_[i] / squares * normal_[i] * normal_[i].transpose())
                      : Mat<D>::Zero();
  }
}

template class Permeability<2>;
template class Permeability<3>;

}  // namespace washtub
