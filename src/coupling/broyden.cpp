#include "coupling/broyden.hpp"

#include <cmath>

namespace washtub {
namespace {

constexpr double least = 0.05;  // of the divisor of a step, below which the update is left out

template <class Nodes>
double dot(const Nodes& a, const Nodes& b) {
  double sum = 0;
  for (std::size_t i = 0; i < a.size(); ++i) sum += a[i].dot(b[i]);
  return sum;
}

}  // namespace

template <int D>
const typename Broyden<D>::Nodes& Broyden<D>::step(const Nodes& R) {
  Nodes z(R.size());
  for (std::size_t i = 0; i < R.size(); ++i) z[i] = -R[i];
  for (std::size_t j = 0; j < steps_.size(); ++j) {
    const Nodes& s = steps_[j];
    const double share = dot(s, z) / std::max(dot(s, s), 1e-300);
    const bool last = j + 1 == steps_.size();
    if (last) {
      const double divisor = std::abs(1 - share) > least ? 1 - share : 1;
      for (auto& v : z) v /= divisor;
    } else {
      for (std::size_t i = 0; i < z.size(); ++i) z[i] += share * steps_[j + 1][i];
    }
  }
  steps_.push_back(std::move(z));
  return steps_.back();
}

template class Broyden<2>;
template class Broyden<3>;

}  // namespace washtub
