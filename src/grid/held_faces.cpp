#include "grid/held_faces.hpp"

#include <algorithm>

namespace washtub {

void HeldFaces::update() {
  if (looked_.empty() && fresh_.empty()) return;
  const auto before = [](const auto& a, const auto& b) { return a.p < b.p; };
  std::sort(looked_.begin(), looked_.end());
  std::sort(fresh_.begin(), fresh_.end(), before);
  const auto same = [](const auto& a, const auto& b) { return a.p == b.p; };
  fresh_.erase(std::unique(fresh_.begin(), fresh_.end(), same), fresh_.end());
  auto look = looked_.begin();
  std::erase_if(faces_, [&](const auto& face) {
    while (look != looked_.end() && *look < face.p) ++look;
    return look != looked_.end() && *look == face.p;
  });
  merged_.resize(faces_.size() + fresh_.size());
  std::merge(faces_.begin(), faces_.end(), fresh_.begin(), fresh_.end(), merged_.begin(), before);
  faces_.swap(merged_);
  looked_.clear();
  fresh_.clear();
  std::fill(first_.begin(), first_.end(), 0);
  for (const auto& face : faces_) ++first_[face.row + 1];
  for (std::size_t r = 1; r < first_.size(); ++r) first_[r] += first_[r - 1];
}

}  // namespace washtub
