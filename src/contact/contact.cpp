#include "contact/contact.hpp"

#include <cmath>

namespace washtub {
namespace {

constexpr double skin = 0.25;  // of the range: by how much farther lists of pairs reach

}  // namespace

template <int D>
std::vector<std::vector<double>> friction_of_groups(const Cloth<D>& cloth) {
  std::vector<std::vector<double>> friction;
  for (const auto& a : cloth.groups) {
    auto& row = friction.emplace_back();
    for (const auto& b : cloth.groups)
      row.push_back(std::sqrt(a.sheet.material.friction * b.sheet.material.friction));
  }
  return friction;
}

template <int D>
Contact<D>::Contact(const ClothSurface<D>& surface, const Cloth<D>& cloth, const Mesh<D>& mesh,
                    const Parallel& parallel, const ContactSettings& settings)
    : surface_(surface),
      gap_(settings.gap),
      list_(surface, mesh, skin * settings.range, Share(parallel)),
      held_(surface, parallel, settings.gap, friction_of_groups(cloth)),
      filter_(surface, parallel) {}

template <int D>
void Contact<D>::hold(HeldStep<D>& step) {
  if (!surface_.place(step.start, from_) || !surface_.place(step.next, to_)) return;
  list_.cover(from_, to_, gap_);
  held_.hold(list_, from_, to_, step);
}

template <int D>
auto Contact<D>::end(const std::vector<Vec<D>>& X, std::vector<Vec<D>>& Y) -> Report {
  const int cut = filter_.cut(list_, X, Y);
  return {held_.count(), cut};
}

template std::vector<std::vector<double>> friction_of_groups(const Cloth<2>&);
template std::vector<std::vector<double>> friction_of_groups(const Cloth<3>&);
template class Contact<2>;
template class Contact<3>;

}  // namespace washtub
