#include "verify/take.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "base/error.hpp"
#include "verify/oscillation.hpp"

namespace washtub {
namespace {

/// Time mean of the samples to the `power` (1 or 2), linear between them.
double time_mean(std::span<const double> t, std::span<const double> v, int power) {
  if (t.size() == 1) return power == 1 ? v[0] : v[0] * v[0];
  double sum = 0;
  for (std::size_t i = 1; i < t.size(); ++i) {
    const double a = v[i - 1], b = v[i];
    sum += (t[i] - t[i - 1]) * (power == 1 ? (a + b) / 2 : (a * a + b * b) / 2);
  }
  return sum / (t.back() - t.front());
}

double slope(std::span<const double> t, std::span<const double> v) {
  const double n = static_cast<double>(t.size());
  double t_mean = 0, v_mean = 0, products = 0, squares = 0;
  for (std::size_t i = 0; i < t.size(); ++i) {
    t_mean += t[i] / n;
    v_mean += v[i] / n;
  }
  for (std::size_t i = 0; i < t.size(); ++i) {
    products += (t[i] - t_mean) * (v[i] - v_mean);
    squares += (t[i] - t_mean) * (t[i] - t_mean);
  }
  return products / squares;
}

void check_samples(Take take, std::size_t count) {
  const std::size_t least = take == Take::slope ? 2 : 1;
  if (count < least)
    throw InputError(
        fmt::format("{} samples in the window, {} or more are needed; widen `window` "
                    "or lower output.every of the case",
                    count, least));
}

}  // namespace

const std::vector<std::pair<std::string, Take>>& take_names() {
  static const std::vector<std::pair<std::string, Take>> names = {{"mean", Take::mean},
                                                                  {"rms", Take::rms},
                                                                  {"max", Take::max},
                                                                  {"min", Take::min},
                                                                  {"last", Take::last},
                                                                  {"swing", Take::swing},
                                                                  {"half_swing", Take::half_swing},
                                                                  {"frequency", Take::frequency},
                                                                  {"decay", Take::decay},
                                                                  {"slope", Take::slope}};
  return names;
}

double take_of(Take take, std::span<const double> t, std::span<const double> v) {
  check_samples(take, v.size());
  const auto [low, high] = std::minmax_element(v.begin(), v.end());
  switch (take) {
    case Take::mean:
      return time_mean(t, v, 1);
    case Take::rms:
      return std::sqrt(time_mean(t, v, 2));
    case Take::max:
      return *high;
    case Take::min:
      return *low;
    case Take::last:
      return v.back();
    case Take::swing:
      return *high - *low;
    case Take::half_swing:
      return (*high - *low) / 2;
    case Take::frequency:
      return fit_oscillation(t, v).frequency;
    case Take::decay:
      return fit_oscillation(t, v).decay;
    case Take::slope:
      return slope(t, v);
  }
  throw InputError("unknown take");
}

}  // namespace washtub
