#include "solid/surface_speed.hpp"

#include <gtest/gtest.h>

#include <limits>

namespace washtub {
namespace {

constexpr double inf = std::numeric_limits<double>::infinity();

double fastest(const std::vector<Solid>& solids, const Heaviside& heaviside = {}) {
  const Mesh<2> mesh{{-1.25, -1.25}, {2.5 / 64, 2.5 / 64}, {64, 64}, {}};
  const Grid<2> grid(mesh, Parallel(MPI_COMM_SELF), {1, 1});
  return fastest_surface(grid, DomainMapping<2>(grid, solids, heaviside));
}

const Shape ring = complement(cylinder(1, -inf, inf)), disc = cylinder(0.4, -inf, inf);

/// Within two cells of the surface; corners of the box, which are solid too, do not count.
TEST(SurfaceSpeed, IsThatOfTheFastestSurface) {
  const double cells = 2 * 2.5 / 64;
  const Solid still{"ring", ring, Vec<3>::Zero(), at_rest()};
  EXPECT_NEAR(fastest({still, {"disc", disc, Vec<3>::Zero(), constant_speed(-3)}}), 1.2, 3 * cells);
  EXPECT_NEAR(fastest({{"ring", ring, Vec<3>::Zero(), constant_speed(2)}}), 2, 2 * cells);
  EXPECT_NEAR(fastest({{"disc", disc, {0.3, 0, 0}, sinusoid(3, 1)}}, Heaviside::smooth(2.5 / 32)),
              1.2, 3 * cells);
}

/// A fin that turns is fastest at its tip.
TEST(SurfaceSpeed, OfAFinIsThatOfItsTip) {
  const Shape fin = capsule({0, 0, 0}, {0.7, 0, 0}, 0.05);
  EXPECT_NEAR(fastest({{"fin", fin, Vec<3>::Zero(), constant_speed(4)}}), 3, 4 * 2.5 / 64);
}

TEST(SurfaceSpeed, IsZeroAtRest) {
  EXPECT_EQ(fastest({{"disc", disc, Vec<3>::Zero(), at_rest()}}), 0);
  EXPECT_EQ(fastest({}), 0);
}

}  // namespace
}  // namespace washtub
