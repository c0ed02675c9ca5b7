#include "contact/pair.hpp"

#include <algorithm>

#include "contact/geometry.hpp"

namespace washtub {
namespace {

constexpr double close = 1e-2;  // of the least distance: near enough
constexpr int advances = 200;   // most

/// The mean of the ways, which does not change the distance.
template <int D>
Vec<D> common(const typename Pair<D>::Places& way) {
  Vec<D> mean = Vec<D>::Zero();
  for (const Vec<D>& u : way) mean += u;
  return mean / static_cast<double>(way.size());
}

}  // namespace

template <int D>
Nearness<D> nearest(int split, const typename Pair<D>::Places& x) {
  Nearness<D> out;
  if constexpr (D == 3) {
    if (split == 2) {
      const auto [s, t] = nearest_parameters(x[0], x[1], x[2], x[3]);
      out.weight = {1 - s, s, t - 1, -t};
    } else {
      const auto w = nearest_weights(x[0], {x[1], x[2], x[3]});
      out.weight = {1, -w[0], -w[1], -w[2]};
    }
  } else {
    const auto w = nearest_weights(x[0], {x[1], x[2]});
    out.weight = {1, -w[0], -w[1]};
  }
  out.gap.setZero();
  for (std::size_t k = 0; k < x.size(); ++k) out.gap += out.weight[k] * x[k];
  return out;
}

template <int D>
double closing(int split, const typename Pair<D>::Places& way) {
  const Vec<D> mean = common<D>(way);
  double first = 0, second = 0;
  for (std::size_t k = 0; k < way.size(); ++k) {
    double& most = static_cast<int>(k) < split ? first : second;
    most = std::max(most, (way[k] - mean).squaredNorm());
  }
  return std::sqrt(first) + std::sqrt(second);
}

template <int D>
std::optional<Impact<D>> find_impact(int split, const typename Pair<D>::Places& x,
                                     typename Pair<D>::Places way, double least) {
  const double speed = closing<D>(split, way);
  const Vec<D> mean = common<D>(way);
  for (Vec<D>& u : way) u -= mean;
  Impact<D> out{0, {}, Vec<D>::Zero()};
  for (int i = 0; i < advances; ++i) {
    typename Pair<D>::Places at;
    for (std::size_t k = 0; k < x.size(); ++k) at[k] = x[k] + out.time * way[k];
    const Nearness<D> near = nearest<D>(split, at);
    const double d = near.gap.norm();
    out.weight = near.weight;
    out.normal = d > 0 ? Vec<D>(near.gap / d) : Vec<D>(Vec<D>::Zero());
    if (d <= (1 + close) * least) return out;
    if (!(speed > 0)) return std::nullopt;
    out.time += (d - least) / speed;
    if (out.time >= 1) return std::nullopt;
  }
  return out;
}

template Nearness<2> nearest<2>(int, const Pair<2>::Places&);
template Nearness<3> nearest<3>(int, const Pair<3>::Places&);
template double closing<2>(int, const Pair<2>::Places&);
template double closing<3>(int, const Pair<3>::Places&);
template std::optional<Impact<2>> find_impact<2>(int, const Pair<2>::Places&, Pair<2>::Places,
                                                 double);
template std::optional<Impact<3>> find_impact<3>(int, const Pair<3>::Places&, Pair<3>::Places,
                                                 double);

}  // namespace washtub
