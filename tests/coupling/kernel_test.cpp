#include "coupling/kernel.hpp"

#include <gtest/gtest.h>

#include <cmath>

using namespace washtub;

namespace {

struct Moments {
  double sum = 0, first = 0, even = 0, squares = 0;
};

/// Moments about a marker at x cells of its weights on the grid points.
Moments moments(Kernel kernel, double x) {
  const auto [start, w] = kernel_line(kernel, x);
  Moments m;
  for (int i = 0; i < kernel_points; ++i) {
    m.sum += w[i];
    m.first += w[i] * (start + i - x);
    m.even += std::fmod(start + i, 2) == 0 ? w[i] : 0;
    m.squares += w[i] * w[i];
  }
  return m;
}

template <class Check>
void for_places(Check&& check) {
  for (int i = -250; i <= 250; ++i) check(0.0173 * i);
  for (const double x : {0.0, 0.5, 1.0, 1.5, -3.0}) check(x);
}

}  // namespace

class AnyKernel : public ::testing::TestWithParam<Kernel> {};
INSTANTIATE_TEST_SUITE_P(All, AnyKernel,
                         ::testing::Values(Kernel::cosine, Kernel::roma3, Kernel::peskin4));

TEST_P(AnyKernel, WeightsAddUpToOne) {
  for_places([](double x) { EXPECT_NEAR(moments(GetParam(), x).sum, 1, 1e-14) << x; });
}

TEST_P(AnyKernel, WeightsAreItsValues) {
  for_places([](double x) {
    const auto [start, w] = kernel_line(GetParam(), x);
    for (int i = start - 1; i < start + 5; ++i)
      EXPECT_NEAR(i >= start && i < start + kernel_points ? w[i - start] : 0,
                  kernel_value(GetParam(), x - i), 1e-14)
          << x;
    for (int m = points_of(GetParam()); m < kernel_points; ++m) EXPECT_EQ(w[m], 0);
  });
}

TEST_P(AnyKernel, FindsFacesAndCentresTogether) {
  for_places([](double x) {
    const auto both = kernel_pair(GetParam(), x);
    for (const auto& [line, at] : {std::pair{both.face, x}, {both.centre, x - 0.5}})
      for (int i = line.start - 1; i < line.start + 5; ++i)
        EXPECT_NEAR(
            i >= line.start && i < line.start + kernel_points ? line.weight[i - line.start] : 0,
            kernel_value(GetParam(), at - i), 1e-14)
            << x;
  });
}

TEST_P(AnyKernel, IsNothingBeyondTwoCells) {
  EXPECT_EQ(kernel_value(GetParam(), 2.0), 0);
  EXPECT_EQ(kernel_value(GetParam(), -2.5), 0);
  EXPECT_NEAR(kernel_value(GetParam(), 1.9999999), 0, 1e-6);
}

TEST(Kernels, HaveTheirSumOfSquares) {
  for_places([](double x) {
    EXPECT_NEAR(moments(Kernel::roma3, x).squares, 0.5, 1e-14) << x;
    EXPECT_NEAR(moments(Kernel::peskin4, x).squares, 3.0 / 8, 1e-14) << x;
    EXPECT_NEAR(moments(Kernel::cosine, x).squares, 3.0 / 8, 1e-14) << x;
  });
}

TEST(Kernels, OfFourPointsWeighEvenAndOddPointsAlike) {
  for_places([](double x) {
    EXPECT_NEAR(moments(Kernel::peskin4, x).even, 0.5, 1e-14) << x;
    EXPECT_NEAR(moments(Kernel::cosine, x).even, 0.5, 1e-14) << x;
  });
}

TEST(Kernels, KeepTheCentreOfForceOrNearlySo) {
  double worst = 0;
  for_places([&](double x) {
    EXPECT_NEAR(moments(Kernel::roma3, x).first, 0, 1e-14) << x;
    EXPECT_NEAR(moments(Kernel::peskin4, x).first, 0, 1e-14) << x;
    worst = std::max(worst, std::abs(moments(Kernel::cosine, x).first));
  });
  EXPECT_NEAR(worst, 0.0211, 1e-4);  // cells, at a fraction of 0.213
}

/// Peskin's 4-point functions have sum phi^2 = 3/8 wherever they stand, Roma's 1/2.
TEST(Kernel, TiesALayerOfItsThickness) {
  EXPECT_NEAR(kernel_thickness(Kernel::cosine), 8.0 / 3, 1e-5);
  EXPECT_NEAR(kernel_thickness(Kernel::peskin4), 8.0 / 3, 1e-5);
  EXPECT_NEAR(kernel_thickness(Kernel::roma3), 2, 1e-5);
}
