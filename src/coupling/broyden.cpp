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
  if (count_ == static_cast<int>(steps_.size())) steps_.emplace_back(R.size());
  Nodes& z = steps_[count_];
  for (std::size_t i = 0; i < R.size(); ++i) z[i] = -R[i];
  for (int j = 0; j < count_; ++j) {
    const Nodes& s = steps_[j];
    const double share = dot(s, z) / std::max(dot(s, s), 1e-300);
    const bool last = j + 1 == count_;
    if (last) {
      const double divisor = std::abs(1 - share) > least ? 1 - share : 1;
      for (auto& v : z) v /= divisor;
    } else {
      for (std::size_t i = 0; i < z.size(); ++i) z[i] += share * steps_[j + 1][i];
    }
  }
  ++count_;
  return z;
}

template class Broyden<2>;
template class Broyden<3>;

}  // namespace washtub
