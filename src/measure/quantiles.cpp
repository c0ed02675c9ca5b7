#include "measure/quantiles.hpp"

#include <algorithm>
#include <cmath>

namespace washtub {

template <std::size_t N>
std::array<double, N> quantiles(std::vector<Weighted>& values, const std::array<double, N>& parts) {
  std::sort(values.begin(), values.end(),
            [](const Weighted& a, const Weighted& b) { return a.value < b.value; });
  double whole = 0;
  for (const Weighted& each : values) whole += each.weight;
  std::array<double, N> found;
  for (std::size_t k = 0; k < N; ++k) {
    const double wanted = parts[k] * whole * (1 - 1e-12);
    double sum = 0;
    found[k] = std::nan("");
    for (const Weighted& each : values) {
      found[k] = each.value;
      if ((sum += each.weight) >= wanted) break;
    }
  }
  return found;
}

template std::array<double, 1> quantiles(std::vector<Weighted>&, const std::array<double, 1>&);
template std::array<double, 3> quantiles(std::vector<Weighted>&, const std::array<double, 3>&);

}  // namespace washtub
