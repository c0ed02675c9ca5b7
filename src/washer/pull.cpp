#include "washer/pull.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "base/error.hpp"

namespace washtub {
namespace {

bool pulls(const ClothCase& cloth) { return cloth.count > 0 && cloth.load != ClothCase().load; }

}  // namespace

template <int D>
bool Pull<D>::any(const Case& whole) {
  return std::any_of(whole.cloth.begin(), whole.cloth.end(), pulls);
}

template <int D>
Pull<D>::Pull(const Cloth<D>& cloth, const Case& whole) {
  auto group = cloth.groups.begin();
  for (const ClothCase& given : whole.cloth) {
    if (given.count == 0) continue;
    const auto& sheet = group->sheet;
    const std::size_t first = area_.size();
    for (int p = 0; p < group->pieces; ++p)
      area_.insert(area_.end(), sheet.area.begin(), sheet.area.end());
    if (pulls(given))
      groups_.push_back(
          {first, area_.size(), {given.load, fmt::format("the load of \"{}\",", given.name)}});
    ++group;
  }
  std::vector<Vec<D>> start(area_.size(), Vec<D>::Zero());
  add_forces(cloth.position, start);
}

template <int D>
void Pull<D>::add_forces(const std::vector<Vec<D>>& X, std::vector<Vec<D>>& force) const {
  for (const Group& group : groups_)
    for (std::size_t i = group.first; i < group.last; ++i)
      force[i] += area_[i] * group.field(X[i], time_);
}

template <int D>
void Pull<D>::add(const ClothMoment<D>& now, std::vector<Vec<D>>& force) {
  time_ += now.dt;
  try {
    add_forces(now.position, force);
  } catch (const InputError& error) {  // a formula that was right at the start
    throw RunError(error.what());
  }
}

template class Pull<2>;
template class Pull<3>;

}  // namespace washtub
