#include "coupling/coupling.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <stdexcept>

#include "cloth/plate.hpp"
#include "coupling/pool.hpp"

using namespace washtub;
using namespace washtub::testing;

namespace {

constexpr double pi = std::numbers::pi;
constexpr Material table_4{8e5, 3e2, 1e-5, 1e-5, 0, 0, 2.4e-4};

/// The lateral spacing of the wash at 32 cells, three times finer upwards.
Mesh<3> wash_like() {
  const double h = 0.7128 / 32;
  return {Vec<3>::Constant(0), {h, h, h / 3}, {16, 16, 32}, {true, true, true}};
}

/// A plate of 5 x 5 nodes and 15 cm, tilted out of every plane, stretched `by` along its first
/// edge.
Cloth<3> tilted_plate(const Material& material, double by = 1) {
  const auto sheet = make_plate({5, 5}, {0.0375, 0.0375}, material);
  const Vec<3> r = Vec<3>(2, 1, 0.5).normalized(), s = Vec<3>(-0.25, 0, 1).normalized();
  std::vector<Vec<3>> where;
  for (int j = 0; j < 5; ++j)
    for (int i = 0; i < 5; ++i)
      where.push_back(Vec<3>(0.18, 0.18, 0.12) + 0.0375 * ((i - 2) * by * r + (j - 2) * s));
  Cloth<3> cloth;
  cloth.add(sheet, where);
  return cloth;
}

/// A shear flow in the wash-like pool, and what happened in `steps` steps of dt.
struct Sheared {
  double strain = 0, slip = 0, late_slip = 0;
  int iterations = 0;
};
Sheared shear(Scheme scheme, double dt, int steps) {
  Pool<3> pool(wash_like(), 1, tilted_plate(table_4), scheme);
  const double L = wash_like().size()[2];
  pool.water.start_from(
      [&](int d, const Vec<3>& x) { return d == 0 ? 0.5 * std::sin(2 * pi * x[2] / L) : 0.0; });
  Sheared s;
  for (int i = 0; i < steps && s.strain < 1; ++i) {
    const auto r = pool.step(dt, 1e-4);
    s.strain = std::max(s.strain, std::isnan(r.largest_strain) ? 1 : r.largest_strain);
    s.slip = std::max(s.slip, r.slip);
    if (i >= steps / 2) s.late_slip = std::max(s.late_slip, r.slip);
    s.iterations = std::max(s.iterations, r.iterations);
  }
  return s;
}

/// A square tank with walls and a fin that turns in its middle.
struct FinTank {
  WaterBox<2> water;
  Cloth<2> cloth;
  Coupling<2> coupling;

  explicit FinTank(Scheme scheme)
      : water({cubic_mesh<2>({0, 0}, 1, 32),
               {{"fin", capsule({0, 0, 0}, {0.35, 0, 0}, 0.04), {0.5, 0.5, 0}, constant_speed(2)}},
               1000,
               1}),
        cloth(thread_above_fin()),
        coupling(water.flow, cloth, water.mapping, Kernel::cosine, {}, scheme) {}

  static Cloth<2> thread_above_fin() {
    std::vector<Vec<2>> where;
    for (int i = 0; i < 9; ++i) where.emplace_back(0.45 + 0.05 * i, 0.557);
    Cloth<2> cloth;
    cloth.add(make_thread(9, 0.05, {5e3, 0, 1e-3, 0, 0, 0, 1e-3}), where);
    return cloth;
  }
  Coupling<2>::Report step(double dt) {
    water.move_solids(dt);
    water.flow.predict(dt);
    coupling.push();
    do water.flow.project(1e-4, 60);
    while (coupling.again());
    return coupling.move();
  }
  /// Largest psi of the fin over the nodes [m].
  double deepest() const {
    double psi = -1;
    for (const auto& x : cloth.position)
      psi = std::max(psi, water.mapping.solids()[0].psi({x[0], x[1], 0}, water.t));
    return psi;
  }
};

}  // namespace

class AnyScheme : public ::testing::TestWithParam<Scheme> {};
INSTANTIATE_TEST_SUITE_P(Coupling, AnyScheme,
                         ::testing::Values(Scheme::implicit, Scheme::explicit_euler,
                                           Scheme::broyden));

TEST_P(AnyScheme, CallsOutOfOrderAreRefused) {
  Pool<2> pool(square(), 1, stretched_thread(1.1), GetParam());
  auto& water = pool.water;
  auto& coupling = pool.coupling;
  EXPECT_THROW(coupling.push(), std::logic_error) << "without a prediction";
  for (int s = 0; s < 2; ++s) {
    EXPECT_THROW(coupling.again(), std::logic_error);
    EXPECT_THROW(coupling.move(), std::logic_error);
    water.flow.predict(1e-3);
    coupling.push();
    EXPECT_THROW(coupling.push(), std::logic_error);
    EXPECT_THROW(coupling.again(), std::logic_error) << "without a projection";
    water.flow.project(1e-6, 60);
    EXPECT_THROW(coupling.move(), std::logic_error) << "without asking whether it is enough";
    while (coupling.again()) water.flow.project(1e-6, 60);
    coupling.move();
  }
}

TEST_P(AnyScheme, ClothGoesWithAUniformStream) {
  Pool<3> pool(wash_like(), 1, tilted_plate(table_4), GetParam());
  const Vec<3> U(0.3, -0.2, 0.1);
  pool.water.start_from([&](int d, const Vec<3>&) { return U[d]; });
  const auto start = pool.cloth.position;
  for (int i = 0; i < 5; ++i) pool.step(4e-4);
  for (std::size_t i = 0; i < start.size(); ++i)
    EXPECT_LT((pool.cloth.position[i] - start[i] - 2e-3 * U).norm(), 1e-14);
  EXPECT_LT(pool.largest_force(), 1e-9);  // K_e times a node spacing is 3e4 N
}

TEST_P(AnyScheme, RelaxationLosesEnergyAndNoMomentum) {
  Pool<2> pool(square(), 1, stretched_thread(1.05), GetParam());
  const double dt = GetParam() == Scheme::implicit ? 2e-3 : 2e-4;
  const double start = pool.elastic();
  double before = start;
  for (int i = 0; i < 60; ++i) {
    pool.step(dt);
    EXPECT_LT(pool.force().norm(), 1e-13 * pool.largest_force());
    EXPECT_LT(pool.energy(), before) << i;
    before = pool.energy();
  }
  EXPECT_LT(pool.elastic(), 0.999 * start);
  EXPECT_GT(pool.kinetic, 0);
}

TEST(Coupling, HeavyClothHandsItsMomentumToTheWater) {
  constexpr double excess = 50;  // kg/m^2; the water that a node drags along has some 60
  Pool<2> pool(square(), 1, stretched_thread(1, excess), Scheme::implicit);
  for (auto* V : {&pool.cloth.velocity, &pool.cloth.velocity_before})
    std::fill(V->begin(), V->end(), Vec<2>(0.1, 0.3));
  const double mass = excess * 0.4;
  for (int i = 0; i < 30; ++i) {
    pool.step(2e-3, 1e-8);
    Vec<2> momentum = 1000 * total<2>(pool.water.grid, pool.water.flow.velocity());
    const auto& area = pool.cloth.groups[0].sheet.area;
    for (std::size_t n = 0; n < area.size(); ++n)
      momentum += excess * area[n] * pool.cloth.velocity[n];
    EXPECT_LT((momentum - mass * Vec<2>(0.1, 0.3)).norm(), 1e-8 * mass);
  }
  EXPECT_LT(pool.cloth.velocity[4].norm(), 0.28);  // it has slowed down
}

TEST(Coupling, SchemesAgreeAtSmallSteps) {
  const auto plate = tilted_plate({50, 10, 1e-5, 1e-5, 0, 0.093, 2.4e-4}, 1.02);
  Pool<3> one(wash_like(), 1, plate, Scheme::implicit);
  Pool<3> other(wash_like(), 1, plate, Scheme::explicit_euler);
  for (int i = 0; i < 40; ++i) one.step(2e-4), other.step(2e-4);
  double moved = 0, apart = 0;
  for (std::size_t i = 0; i < plate.position.size(); ++i) {
    moved = std::max(moved, (one.cloth.position[i] - plate.position[i]).norm());
    apart = std::max(apart, (one.cloth.position[i] - other.cloth.position[i]).norm());
  }
  EXPECT_LT(apart, 0.02 * moved);
  EXPECT_NEAR(one.kinetic, other.kinetic, 0.02 * other.kinetic);
}

TEST(Coupling, ImplicitSchemeCarriesStiffClothAtTheStepOfTheFlow) {
  const auto s = shear(Scheme::implicit, 4e-4, 100);  // dt omega_max = 5e-3
  EXPECT_LT(s.strain, 0.01);
  EXPECT_LT(s.late_slip, 0.01 * 0.5);
  EXPECT_LE(s.iterations, 8);
}

/// The explicit scheme blows up from 1.2e-3 s on: strains of 10 and more after 60 steps.
TEST(Coupling, OnlyTheExplicitSchemeIsLimitedByTheCloth) {
  const auto s = shear(Scheme::implicit, 1.6e-3, 60);
  EXPECT_LT(s.strain, 0.01);
  EXPECT_LT(s.late_slip, 0.01 * 0.5);
  EXPECT_GT(shear(Scheme::explicit_euler, 1.6e-3, 30).strain, 0.1);
}

TEST(Coupling, IsTheSameOnAnyNumberOfRanks) {
  const auto plate = tilted_plate(table_4);
  Cloth<3> cloth = plate;
  auto below = plate.position;
  for (auto& x : below) x += Vec<3>(0.01, -0.05, -0.02);
  cloth.add(plate.groups[0].sheet, below);
  Pool<3> all(wash_like(), 1, cloth, Scheme::implicit);
  Pool<3> one(wash_like(), 1, cloth, Scheme::implicit, Parallel(MPI_COMM_SELF));
  for (auto* pool : {&all, &one}) {
    pool->water.start_from(
        [](int d, const Vec<3>& x) { return d == 0 ? 0.5 * std::sin(26 * x[2]) : 0.0; });
    for (int i = 0; i < 10; ++i) pool->step(4e-4, 1e-9);
  }
  for (std::size_t i = 0; i < below.size(); ++i)
    EXPECT_LT((all.cloth.position[i] - one.cloth.position[i]).norm(), 1e-9);
}

/// A step so long that the fin runs over the thread: nodes would be inside it, and are not.
TEST(Coupling, DepthIsThatWithoutTheHold) {
  for (const Scheme scheme : {Scheme::implicit, Scheme::explicit_euler}) {
    FinTank tank(scheme);
    const auto report = tank.step(0.1);
    EXPECT_GT(report.barrier.touched, 0);
    EXPECT_GT(report.barrier.depth, 1e-4);
    EXPECT_LT(report.barrier.depth, 0.1 * 2 * 0.35);
    EXPECT_EQ(report.barrier.penetration, 0);
    EXPECT_LE(tank.deepest(), -0.49 / 32);
  }
}

TEST_P(AnyScheme, FinPushesClothBeforeItself) {
  FinTank tank(GetParam());
  const double dt = GetParam() == Scheme::implicit ? 4e-3 : 4e-4;
  const int steps = static_cast<int>(std::lround(0.4 / dt));
  double moment = 0, touched = 0;
  for (int i = 0; i < steps; ++i) {
    const auto report = tank.step(dt);
    touched += report.barrier.touched;
    moment += tank.coupling.contact_moment(0) * dt;
    ASSERT_LT(report.largest_strain, 0.2) << i;
    ASSERT_LE(tank.deepest(), -0.49 / 32) << i;
  }
  EXPECT_GT(touched, 0);
  EXPECT_GT(tank.cloth.position[4][1], 0.65);
  if (GetParam() == Scheme::implicit) {
    EXPECT_LT(moment, 0);  // the cloth holds the fin back
  }
}
