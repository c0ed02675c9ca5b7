#include "cloth/boxes.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace washtub {
namespace {

constexpr double bins_per_box = 8;  // at most

}  // namespace

template <int D>
BoxLists<D>::BoxLists(const std::vector<BoundingBox<D>>& boxes, const Mesh<D>& mesh, double longest)
    : mesh_(mesh) {
  Vec<D> upper = lower_ = mesh.lower;
  double edge = 0;
  for (const auto& b : boxes) {
    lower_ = lower_.cwiseMin(b.middle());
    upper = upper.cwiseMax(b.middle());
    edge = std::max(edge, b.size().maxCoeff());
  }
  const double reach = std::max(0.5 * (edge + longest), 1e-30);
  const double most =
      std::ceil(std::pow(bins_per_box * static_cast<double>(boxes.size() + 1), 1.0 / D));
  for (int d = 0; d < D; ++d) {
    period_[d] = mesh.periodic[d] ? mesh.size()[d] : 0;
    const double length = mesh.periodic[d] ? period_[d] : upper[d] - lower_[d];
    bins_[d] = static_cast<int>(std::clamp(std::floor(length / reach), 1.0, most));
    width_[d] = length > 0 ? length / bins_[d] : 1;
  }
  std::vector<long> bin_of;
  for (const auto& b : boxes) bin_of.push_back(number(bin(b.middle())));
  original_.resize(boxes.size());
  std::iota(original_.begin(), original_.end(), std::size_t{0});
  std::stable_sort(original_.begin(), original_.end(),
                   [&](std::size_t a, std::size_t b) { return bin_of[a] < bin_of[b]; });
  long all = 1;
  for (const int n : bins_) all *= n;
  first_.assign(static_cast<std::size_t>(all) + 1, 0);
  for (const long n : bin_of) ++first_[static_cast<std::size_t>(n) + 1];
  std::partial_sum(first_.begin(), first_.end(), first_.begin());
  for (const std::size_t i : original_) boxes_.push_back(boxes[i]);
}

/// The bin of a point; of the nearest one where the point lies outside them all.
template <int D>
Index<D> BoxLists<D>::bin(const Vec<D>& x) const {
  Index<D> b;
  for (int d = 0; d < D; ++d) {
    double at = x[d] - lower_[d];
    if (period_[d] > 0) at -= period_[d] * std::floor(at / period_[d]);
    b[d] = static_cast<int>(std::clamp(std::floor(at / width_[d]), 0.0, bins_[d] - 1.0));
  }
  return b;
}

template <int D>
long BoxLists<D>::number(const Index<D>& bin) const {
  long n = 0;
  for (int d = D - 1; d >= 0; --d) n = n * bins_[d] + bin[d];
  return n;
}

template class BoxLists<2>;
template class BoxLists<3>;

}  // namespace washtub
