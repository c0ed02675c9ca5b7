#include "verify/take.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <random>

#include "base/error.hpp"
#include "verify/oscillation.hpp"

namespace washtub {
namespace {

using std::numbers::pi;

struct Signal {
  std::vector<double> times, values;

  double take(Take what) const { return take_of(what, times, values); }
};

/// Samples of f every `step` from `begin` on.
template <class F>
Signal sampled(double begin, double step, int count, F f) {
  Signal s;
  for (int i = 0; i < count; ++i) {
    s.times.push_back(begin + i * step);
    s.values.push_back(f(s.times.back()));
  }
  return s;
}

TEST(Take, MeansAreExactOverAWholePeriodWithBothItsEnds) {
  const auto s = sampled(0, 0.05, 41, [](double t) { return 3 + 2 * std::sin(2 * pi * t / 2); });
  EXPECT_NEAR(s.take(Take::mean), 3, 1e-12);
  EXPECT_NEAR(s.take(Take::rms), std::sqrt(9 + 2), 1e-12);
}
TEST(Take, MeansWeighUnevenSamplesByTime) {
  const Signal s{{0, 1, 1.5, 4}, {0, 2, 3, 8}};  // 2 t
  EXPECT_NEAR(s.take(Take::mean), 4, 1e-12);
  EXPECT_NEAR(s.take(Take::slope), 2, 1e-12);
}
TEST(Take, ExtremesAndTheLast) {
  const Signal s{{0, 1, 2, 3}, {1, -4, 6, 2}};
  EXPECT_EQ(s.take(Take::max), 6);
  EXPECT_EQ(s.take(Take::min), -4);
  EXPECT_EQ(s.take(Take::last), 2);
  EXPECT_EQ(s.take(Take::swing), 10);
  EXPECT_EQ(s.take(Take::half_swing), 5);
}
TEST(Take, OneSampleIsItsOwnMean) {
  const Signal s{{2}, {-3}};
  EXPECT_EQ(s.take(Take::mean), -3);
  EXPECT_EQ(s.take(Take::rms), 3);
}

TEST(Oscillation, ExactForADampedCosineWithFewSamplesPerPeriod) {
  const double a = 0.6855, w = 6.40622;
  const auto s = sampled(0.3, 2 * pi / w / 5.3, 24,
                         [=](double t) { return 0.2 + std::exp(-a * t) * std::cos(w * t + 0.4); });
  EXPECT_NEAR(s.take(Take::frequency), w / 2 / pi, 1e-8);
  EXPECT_NEAR(s.take(Take::decay), a, 1e-8);
}
TEST(Oscillation, GrowingOnesHaveANegativeDecay) {
  const auto s =
      sampled(0, 0.02, 200, [](double t) { return std::exp(0.5 * t) * std::sin(9 * t); });
  EXPECT_NEAR(s.take(Take::decay), -0.5, 1e-8);
}
TEST(Oscillation, FrequencyOfANoisySine) {
  std::mt19937 random(7);
  std::normal_distribution<double> noise(0, 0.1);
  const auto s = sampled(5, 0.15, 200, [&](double t) {
    return -4 + 0.7 * std::sin(2 * pi * 1.31 * t) + noise(random);
  });
  EXPECT_NEAR(s.take(Take::frequency) / 1.31, 1, 1e-3);
  EXPECT_NEAR(s.take(Take::decay), 0, 0.02);
}
TEST(Oscillation, FundamentalOfAPeriodicSignalWithHarmonics) {
  const auto s = sampled(0, 0.05, 400, [](double t) {
    const double x = 2 * pi * 0.3 * t;
    return std::sin(x) + 0.3 * std::sin(3 * x + 1) + 0.1 * std::cos(2 * x);
  });
  EXPECT_NEAR(s.take(Take::frequency) / 0.3, 1, 2e-3);
}
TEST(Oscillation, RefusesWhatDoesNotOscillate) {
  const auto line = sampled(0, 0.1, 50, [](double t) { return t; });
  EXPECT_THROW(line.take(Take::frequency), InputError);
  const Signal few{{0, 1, 2}, {1, -1, 1}};
  EXPECT_THROW(few.take(Take::decay), InputError);
  const Signal none;
  EXPECT_THROW(none.take(Take::mean), InputError);
}

}  // namespace
}  // namespace washtub
