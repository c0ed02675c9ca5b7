#include "contact/filter.hpp"

#include <algorithm>

namespace washtub {
namespace {

constexpr double keeps = 0.1;   // of its distance, that a pair has left at least
constexpr double before = 0.9;  // of the time of impact, as far as a piece goes
constexpr int rounds = 20;      // then pieces stop

}  // namespace

/// Cuts the factors of the pieces of a pair that comes too near; returns whether it does.
template <int D>
bool CrossingFilter<D>::look(const Pair<D>& pair, bool stop) {
  const auto at = pair.places(from_);
  auto way = pair.places(to_);
  for (std::size_t k = 0; k < at.size(); ++k) way[k] -= at[k];
  const double d = nearest<D>(pair.split, at).gap.norm();
  if (!(d > 0) || d * (1 - keeps) > closing<D>(pair.split, way)) return false;
  const auto impact = find_impact<D>(pair.split, at, way, keeps * d);
  if (!impact) return false;
  for (const int point : pair.point) {
    double& f = factor_[surface_.piece[point]];
    f = std::min(f, stop ? 0.0 : before * impact->time);
  }
  return true;
}

/// On return each piece has the factor by which it has to be cut; false if none has to.
template <int D>
bool CrossingFilter<D>::find_factors(const PairList<D>& list, bool stop) {
  std::fill(factor_.begin(), factor_.end(), 1.0);
  bool any = false;
  list.for_closing(keeps, [&](const Pair<D>& pair) { any = look(pair, stop) || any; });
  return parallel_.any(any);
}

template <int D>
int CrossingFilter<D>::cut(PairList<D>& list, const std::vector<Vec<D>>& X,
                           std::vector<Vec<D>>& Y) {
  factor_.assign(static_cast<std::size_t>(surface_.pieces()), 1);
  fraction_ = factor_;
  whole_ = Y;
  shortest_ = 1;
  if (!surface_.place(X, from_) || !surface_.place(Y, to_)) return 0;
  list.cover(from_, to_, 0);
  for (int round = 0; find_factors(list, round >= rounds); ++round) {
    parallel_.min(std::span(factor_));
    for (std::size_t p = 0; p < factor_.size(); ++p) fraction_[p] *= factor_[p];
    for (std::size_t i = 0; i < Y.size(); ++i)
      if (const double f = fraction_[static_cast<std::size_t>(surface_.piece[i])]; f < 1)
        Y[i] = X[i] + f * (whole_[i] - X[i]);
    surface_.place(Y, to_);
  }
  for (const double f : fraction_) shortest_ = std::min(shortest_, f);
  return static_cast<int>(
      std::count_if(fraction_.begin(), fraction_.end(), [](double f) { return f < 1; }));
}

template class CrossingFilter<2>;
template class CrossingFilter<3>;

}  // namespace washtub
