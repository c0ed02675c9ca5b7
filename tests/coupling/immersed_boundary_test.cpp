#include "coupling/immersed_boundary.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>

#include "base/error.hpp"
#include "cloth/plate.hpp"
#include "coupling/faces.hpp"

using namespace washtub;
using namespace washtub::testing;

namespace {

constexpr Kernel kernels[] = {Kernel::cosine, Kernel::roma3, Kernel::peskin4};

/// An anisotropic box, periodic along x, walls along y, floor and free surface along the last axis.
template <int D>
Mesh<D> tank() {
  Mesh<D> m;
  m.lower = Vec<D>::Constant(-0.3);
  m.h = Vec<D>::Constant(0.05);
  m.h[D - 1] = 0.05 / D;
  m.cells.fill(16);
  m.cells[D - 1] = 24;
  m.periodic[0] = true;
  return m;
}

template <int D>
SidePairs<D> tank_sides() {
  SidePairs<D> sides;
  sides[D - 1][1].kind = Side<D>::Kind::slip;
  return sides;
}

template <int D>
struct Tank {
  Grid<D> grid;
  Cloth<D> cloth;
  ImmersedBoundary<D> boundary;

  Tank(const Cloth<D>& cloth_, Kernel kernel, const Parallel& parallel = Parallel(),
       const SidePairs<D>& sides = tank_sides<D>())
      : grid(tank<D>(), parallel, granularity(tank<D>())),
        cloth(cloth_),
        boundary(grid, cloth, kernel, sides) {
    boundary.place(cloth.position);
  }
  std::array<Field, D> spread(const std::vector<Vec<D>>& G) const {
    auto f = make_fields<D>(grid);
    boundary.spread(G, f);
    return f;
  }
  /// Velocity of the nodes in the water whose faces have u = value(axis, cell, position).
  template <class Value>
  std::vector<Vec<D>> velocity(Value&& value) const {
    auto u = make_fields<D>(grid);
    fill_faces<D>(grid, u, value);
    std::vector<Vec<D>> U(cloth.position.size());
    boundary.interpolate(u, U);
    return U;
  }
};

template <int D>
double noise(int axis, const Index<D>& c, const Vec<D>&) {
  std::uint64_t key = 3;
  for (int d = 0; d < D; ++d) key = 1000 * key + c[d];
  return scatter(10 * key + axis);
}

template <int D>
std::vector<Vec<D>> random_forces(std::size_t count) {
  std::vector<Vec<D>> G(count);
  for (std::size_t i = 0; i < count; ++i)
    for (int d = 0; d < D; ++d) G[i][d] = scatter(7000 + 10 * i + d);
  return G;
}

/// Points at least two cells from every side.
template <int D>
std::vector<Vec<D>> inner_points(int count) {
  auto points = points_in(tank<D>(), count);
  for (auto& x : points)
    for (int d = 0; d < D; ++d)
      x[d] = std::clamp(x[d], tank<D>().lower[d] + 2.6 * tank<D>().h[d],
                        tank<D>().lower[d] + (tank<D>().cells[d] - 2.6) * tank<D>().h[d]);
  return points;
}

/// A plate whose markers are finer than its nodes along the last axis, across the whole tank.
Cloth<3> coarse_plate() {
  const auto sheet = make_plate({4, 5}, {0.08, 0.08}, {10, 1, 1e-3, 1e-3, 0, 0, 1e-3});
  std::vector<Vec<3>> where;
  for (int j = 0; j < 5; ++j)
    for (int i = 0; i < 4; ++i) where.emplace_back(-0.25 + 0.08 * i, 0.02 * i, -0.28 + 0.08 * j);
  Cloth<3> cloth;
  cloth.add(sheet, where);
  return cloth;
}

template <int D>
void expect_adjoint(const Tank<D>& tank) {
  const auto G = random_forces<D>(tank.cloth.position.size());
  const auto f = tank.spread(G);
  const auto U = tank.velocity(noise<D>);
  double power = 0, nodes = 0, size = 0;
  auto u = make_fields<D>(tank.grid);
  fill_faces<D>(tank.grid, u, noise<D>);
  for (int d = 0; d < D; ++d)
    for (std::size_t p = 0; p < f[d].size(); ++p) power += f[d][p] * u[d][p];
  power = tank.grid.parallel().sum(power) * tank.grid.mesh().cell_volume();
  for (std::size_t i = 0; i < G.size(); ++i) nodes += G[i].dot(U[i]), size += G[i].norm();
  EXPECT_NEAR(power, nodes, 1e-14 * size);
}

}  // namespace

TEST(ImmersedBoundary, SpreadsAndInterpolatesAsAdjoints) {
  for (const Kernel kernel : kernels) {
    expect_adjoint(Tank<2>(dots(points_in(tank<2>(), 200)), kernel));
    expect_adjoint(Tank<3>(dots(points_in(tank<3>(), 200)), kernel));
    expect_adjoint(Tank<3>(coarse_plate(), kernel));
  }
}

class AnyWidth : public ::testing::TestWithParam<Kernel> {};
INSTANTIATE_TEST_SUITE_P(ImmersedBoundary, AnyWidth,
                         ::testing::Values(Kernel::cosine, Kernel::roma3));

TEST_P(AnyWidth, IsTheSameOnAnyNumberOfRanks) {
  const auto cloth = dots(points_in(tank<3>(), 150));
  const auto G = random_forces<3>(cloth.position.size());
  const Tank<3> all(cloth, GetParam()), one(cloth, GetParam(), Parallel(MPI_COMM_SELF));
  const auto U = all.velocity(noise<3>), V = one.velocity(noise<3>);
  for (std::size_t i = 0; i < U.size(); ++i) EXPECT_LT((U[i] - V[i]).norm(), 1e-14);
  const auto f = all.spread(G), g = one.spread(G);
  const auto& a = all.grid.block();
  const auto& b = one.grid.block();
  for (int d = 0; d < 3; ++d)
    for (int k = 0; k < a.planes(); ++k)
      for (int j = 0; j < a.rows(); ++j)
        for (int i = 0; i < a.width(); ++i)
          ASSERT_NEAR(f[d][a.row(j, k) + i], g[d][b.row(j + a.offset[1], k + a.offset[2]) + i],
                      1e-9);  // of 1e3 to 1e4
}

TEST(ImmersedBoundary, SpreadsTheWholeForce) {
  for (const Kernel kernel : kernels) {
    const Tank<3> tank(dots(inner_points<3>(100)), kernel);
    const auto G = random_forces<3>(100);
    Vec<3> sum = Vec<3>::Zero();
    for (const auto& g : G) sum += g;
    EXPECT_LT((total<3>(tank.grid, tank.spread(G)) - sum).norm(), 1e-12);
  }
}

/// First moments sum x_e F_d, which hold both the moment and the stress.
TEST(ImmersedBoundary, SpreadsTheForceAboutItsNode) {
  for (const Kernel kernel : kernels) {
    const Tank<3> tank(dots(inner_points<3>(1)), kernel);
    const Vec<3> x = tank.cloth.position[0];
    Eigen::Matrix3d moment = Eigen::Matrix3d::Zero();
    for_faces<3>(tank.grid, tank.spread({Vec<3>(1, 2, 3)}),
                 [&](int d, double f, const Vec<3>& y) { moment.col(d) += f * (y - x); });
    tank.grid.parallel().sum(std::span<double>(moment.data(), 9));
    moment *= tank.grid.mesh().cell_volume();
    const double bound = kernel == Kernel::cosine ? 0.0212 * 0.05 * 3 : 1e-14;
    EXPECT_LT(moment.cwiseAbs().maxCoeff(), bound);
  }
}

TEST(ImmersedBoundary, ReproducesUniformFlow) {
  for (const Kernel kernel : kernels)
    for (const auto& U :
         Tank<3>(dots(inner_points<3>(50)), kernel).velocity([](int d, const auto&, const auto&) {
           return 1.0 + d;
         }))
      EXPECT_LT((U - Vec<3>(1, 2, 3)).norm(), 1e-13);
}

TEST(ImmersedBoundary, ReproducesLinearFlow) {
  const auto linear = [](int d, const auto&, const Vec<3>& x) {
    return x[d] + 2 * x[(d + 1) % 3] - x[(d + 2) % 3];
  };
  for (const Kernel kernel : {Kernel::roma3, Kernel::peskin4}) {
    const Tank<3> tank(dots(inner_points<3>(50)), kernel);
    const auto U = tank.velocity(linear);
    for (std::size_t i = 0; i < U.size(); ++i)
      for (int d = 0; d < 3; ++d) EXPECT_NEAR(U[i][d], linear(d, 0, tank.cloth.position[i]), 1e-13);
  }
}

TEST(ImmersedBoundary, RepeatsWithThePeriodOfTheBox) {
  const double period = 16 * 0.05;
  const Vec<3> x(0.471, 0.1, 0), step(period, 0, 0);
  const Tank<3> tank(dots<3>({x, x - 3 * step, x + 2 * step}), Kernel::cosine);
  const auto U = tank.velocity(noise<3>);
  EXPECT_LT((U[1] - U[0]).norm(), 1e-12);
  EXPECT_LT((U[2] - U[0]).norm(), 1e-12);
}

TEST(ImmersedBoundary, SpreadsAnyNumberOfPeriodsAway) {
  const Vec<3> x(0.471, 0.1, 0), step(16 * 0.05, 0, 0);
  const auto f = Tank<3>(dots<3>({x}), Kernel::cosine).spread({Vec<3>(1, 2, 3)});
  for (const int periods : {3, -2}) {
    const auto far = Tank<3>(dots<3>({x + periods * step}), Kernel::cosine).spread({{1, 2, 3}});
    for (int d = 0; d < 3; ++d)
      for (std::size_t p = 0; p < f[d].size(); ++p) ASSERT_NEAR(far[d][p], f[d][p], 1e-7);
  }
}

namespace {

/// Sides that move along themselves or let water in.
SidePairs<2> driven_sides() {
  using Kind = Side<2>::Kind;
  return {{{Side<2>{Kind::inflow, {0.7, 0.2}}, {Kind::inflow, {-0.4, 1.1}}},
           {Side<2>{Kind::wall, {0.3, 9}}, {Kind::wall, {1.5, 0}}}}};
}

Mesh<2> closed_box() { return {{0, 0}, {0.05, 0.05}, {16, 16}, {false, false}}; }

/// The velocity of one node in water with u = flow(axis, x) on all faces but those on upper sides.
template <class FlowOf>
Vec<2> velocity_near_driven_sides(const Vec<2>& x, Kernel kernel, FlowOf&& flow) {
  const Grid<2> grid(closed_box(), Parallel(), granularity(closed_box()));
  const auto cloth = dots<2>({x});
  ImmersedBoundary<2> boundary(grid, cloth, kernel, driven_sides());
  boundary.place(cloth.position);
  auto u = make_fields<2>(grid);
  fill_faces<2>(grid, u, [&](int d, const auto&, const Vec<2>& y) { return flow(d, y); });
  std::vector<Vec<2>> U(1);
  boundary.interpolate(u, U);
  return U[0];
}

}  // namespace

/// These kernels reproduce linear flow, also where it reaches beyond the side.
TEST(ImmersedBoundary, KnowsHowSidesMove) {
  for (const int side : {0, 1})
    for (const double cells : {0.0, 0.3, 0.5, 1.2}) {
      const double at = side == 0 ? 0 : 0.8, in = side == 0 ? 0.05 * cells : 0.8 - 0.05 * cells;
      for (const int axis : {0, 1}) {
        Vec<2> wall = driven_sides()[axis][side].velocity;
        if (axis == 1) wall[1] = 0;
        Vec<2> x(0.41, 0.41);
        x[axis] = in;
        const Vec<2> slope(3, -2);
        const auto flow = [&](int d, const Vec<2>& y) {
          return wall[d] + slope[d] * (y[axis] - at);
        };
        for (const Kernel kernel : {Kernel::peskin4, Kernel::roma3}) {
          const auto U = velocity_near_driven_sides(x, kernel, flow);
          for (int d = 0; d < 2; ++d) EXPECT_NEAR(U[d], flow(d, x), 1e-13);
        }
      }
    }
}

TEST(ImmersedBoundary, RefusesClothAtAnOpenSide) {
  const Grid<2> grid(closed_box(), Parallel(), granularity(closed_box()));
  for (const auto kind : {Side<2>::Kind::outflow, Side<2>::Kind::far_field}) {
    auto sides = driven_sides();
    sides[0][1].kind = kind;
    const auto cloth = dots<2>({{0.1, 0.1}, {0.69, 0.4}});
    ImmersedBoundary<2> boundary(grid, cloth, Kernel::cosine, sides);
    EXPECT_NO_THROW(boundary.place(cloth.position));
    try {
      boundary.place({{0.1, 0.1}, {0.71, 0.4}});
      FAIL();
    } catch (const RunError& error) {
      const std::string text = error.what();
      EXPECT_EQ(text.find("piece 2 is less than two cells from the upper x side"), 0u) << text;
    }
  }
}

TEST(ImmersedBoundary, MeetsTheWallsAsTheWaterDoes) {
  const double wall = -0.3, surface = -0.3 + 24 * 0.05 / 3;
  const Tank<3> tank(dots<3>({{0.1, wall, 0}, {0.1, 0.1, wall}, {0.1, 0.1, surface}}),
                     Kernel::cosine);
  const auto U = tank.velocity([](int d, const auto&, const auto&) { return d == 0 ? 1.0 : 0.0; });
  EXPECT_NEAR(U[0][0], 0, 1e-14);
  EXPECT_NEAR(U[1][0], 0, 1e-14);
  EXPECT_NEAR(U[2][0], 1, 1e-14);
  const auto V = tank.velocity(
      [&](int d, const auto&, const Vec<3>& x) { return d > 0 && x[d] < wall + 1e-9 ? 0.0 : 1.0; });
  EXPECT_NEAR(V[0][1], 0, 1e-14);
  EXPECT_NEAR(V[1][2], 0, 1e-14);
  EXPECT_NEAR(V[2][2], 0, 1e-14);
}

namespace {

/// Mobility of nodes when faces closed(position) are closed.
template <class Closed>
std::vector<Vec<3>> mobility(const std::vector<Vec<3>>& where, Kernel kernel, Closed&& closed) {
  Tank<3> tank(dots(where), kernel);
  std::array<Storage<float>, 3> open;
  Openings<3> openings;
  auto shut = make_fields<3>(tank.grid);
  fill_faces<3>(tank.grid, shut,
                [&](int, const auto&, const Vec<3>& x) { return closed(x) ? 0.0 : 1.0; });
  for (int d = 0; d < 3; ++d) {
    open[d] = Storage<float>(shut[d].size());
    for (std::size_t p = 0; p < shut[d].size(); ++p) open[d][p] = static_cast<float>(shut[d][p]);
    openings.open[d] = open[d].data();
  }
  std::vector<Vec<3>> D(where.size());
  tank.boundary.mobility(openings, 1000, D);
  return D;
}

const double cell_mass = 1000 * 0.05 * 0.05 * 0.05 / 3;

}  // namespace

TEST(Mobility, OfALoneMarkerIsItsSumOfSquares) {
  const auto open = [](const Vec<3>&) { return false; };
  for (const auto& [kernel, squares] :
       {std::pair{Kernel::cosine, 0.375}, {Kernel::roma3, 0.5}, {Kernel::peskin4, 0.375}})
    for (const auto& D : mobility({{0.013, 0.117, 0.0021}}, kernel, open))
      for (int c = 0; c < 3; ++c) EXPECT_NEAR(D[c] * cell_mass, std::pow(squares, 3), 1e-12);
}

TEST(Mobility, AddsUpOverNodesThatArePushedAlike) {
  const Vec<3> x(0.013, 0.117, 0.0021);
  const auto open = [](const Vec<3>&) { return false; };
  const auto D = mobility({x, x, x + Vec<3>(0, -0.25, 0)}, Kernel::cosine, open);
  EXPECT_NEAR(D[0][1] * cell_mass, 2 * std::pow(0.375, 3), 1e-12);
  EXPECT_NEAR(D[2][1] * cell_mass, std::pow(0.375, 3), 1e-12);
}

TEST(Mobility, IsThatOfTheOpenFacesAloneAndHasAFloor) {
  const double x = -0.3 + 6 * 0.05;  // on faces normal to x
  const auto closed = [&](const Vec<3>& y) { return y[0] < x - 1e-9; };
  const auto D = mobility({{x, 0.1, 0}, {-0.2, 0.1, 0}}, Kernel::cosine, closed);
  // weights 1/4, 1/2, 1/4 on the faces along x: the first one is closed
  EXPECT_NEAR(D[0][0] * cell_mass, (0.25 + 0.0625) * 0.375 * 0.375, 1e-12);
  EXPECT_NEAR(D[1][0] * cell_mass, 0.02, 1e-12);
}
