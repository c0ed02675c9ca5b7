#include <gtest/gtest.h>

#include <numbers>

#include "base/error.hpp"
#include "support/water_box.hpp"

namespace washtub {
namespace {

using testing::cubic_mesh;
using testing::WaterBox;
using testing::WaterSetup;

template <int D>
using Kind = typename Side<D>::Kind;

/// A box whose water enters on one side and leaves on the opposite one; `entry` 0 enters below.
template <int D>
WaterSetup<D> channel(int along, int entry, const Vec<D>& velocity, Kind<D> lateral, int n) {
  WaterSetup<D> s{.mesh = cubic_mesh<D>(Vec<D>::Zero(), 1, n), .viscosity = 0.01};
  for (auto& axis : s.sides)
    for (auto& side : axis) side.kind = lateral;
  s.sides[along][entry] = {Kind<D>::inflow, velocity};
  s.sides[along][1 - entry].kind = Kind<D>::outflow;
  return s;
}

/// Normal velocity summed over the faces of a side, all ranks.
template <int D>
double through(const WaterBox<D>& box, int axis, int side) {
  double sum = 0;
  const auto& block = box.grid.block();
  box.for_cells([&](const Index<D>& c, long p) {
    const int at = side == 0 ? 0 : block.count[axis] - 1;
    if (c[axis] == at && box.grid.at_side(axis, side))
      sum += box.flow.velocity()[axis][p + side * block.stride[axis]];
  });
  return box.grid.parallel().sum(sum);
}

template <int D>
void expect_uniform(int along, int entry, Kind<D> lateral, const Heaviside& heaviside = {}) {
  Vec<D> stream = Vec<D>::Zero();
  stream[along] = entry == 0 ? 1.5 : -1.5;
  auto setup = channel<D>(along, entry, stream, lateral, 16);
  setup.heaviside = heaviside;
  WaterBox<D> box(setup);
  box.flow.set_velocity([&](const Vec<D>&) { return stream; });
  for (int s = 0; s < 10; ++s) box.step(0.01, 1e-12);
  EXPECT_LE(box.error([&](int d, const Vec<D>&) { return stream[d]; }), 1e-13)
      << D << "-D, along " << along << ", entry " << entry;
}

TEST(PassingWater, UniformStreamStaysUniform) {
  for (int entry = 0; entry < 2; ++entry) {
    for (int along = 0; along < 2; ++along) {
      expect_uniform<2>(along, entry, Kind<2>::slip);
      expect_uniform<2>(along, entry, Kind<2>::far_field);
    }
    for (int along = 0; along < 3; ++along) expect_uniform<3>(along, entry, Kind<3>::far_field);
  }
}

/// The sides of the box are not solids: a mapping that holds water to solids leaves that on the
/// sides alone.
TEST(PassingWater, MappingDoesNotHoldTheStream) {
  for (int entry = 0; entry < 2; ++entry)
    for (int along = 0; along < 2; ++along)
      for (const auto& heaviside : {Heaviside::smooth(0.1), Heaviside::gradual()})
        expect_uniform<2>(along, entry, Kind<2>::far_field, heaviside);
}

/// An oblique stream through a box that is periodic across.
template <int D>
void expect_uniform_through_periods(int along, int entry) {
  Vec<D> stream = Vec<D>::Constant(0.5);
  stream[along] = entry == 0 ? 1.0 : -1.0;
  auto setup = channel<D>(along, entry, stream, Kind<D>::periodic, 16);
  for (int d = 0; d < D; ++d) setup.mesh.periodic[d] = d != along;
  WaterBox<D> box(setup);
  box.flow.set_velocity([&](const Vec<D>&) { return stream; });
  for (int s = 0; s < 10; ++s) box.step(0.01, 1e-12);
  EXPECT_LE(box.error([&](int d, const Vec<D>&) { return stream[d]; }), 1e-12)
      << D << "-D, along " << along << ", entry " << entry;
}

TEST(PassingWater, ObliqueStreamThroughPeriodsStaysUniform) {
  for (int entry = 0; entry < 2; ++entry) {
    for (int along = 0; along < 2; ++along) expect_uniform_through_periods<2>(along, entry);
    for (int along = 0; along < 3; ++along) expect_uniform_through_periods<3>(along, entry);
  }
}

/// Water at rest takes up the stream at once: between slip sides the first projection leaves the
/// uniform flow, to the accuracy of the viscous solve.
TEST(PassingWater, InflowFillsABoxThatStartsAtRest) {
  WaterBox<2> box(channel<2>(1, 0, Vec<2>(0, 2), Kind<2>::slip, 16));
  box.step(0.01, 1e-13);
  EXPECT_LE(box.error([](int d, const Vec<2>&) { return d == 1 ? 2.0 : 0.0; }), 1e-5);
}

/// An inclined stream crosses the box from two inflow sides to two outflow sides.
TEST(PassingWater, ObliqueStreamStaysUniform) {
  WaterSetup<2> s{.mesh = cubic_mesh<2>(Vec<2>::Zero(), 1, 16), .viscosity = 0.01};
  const Vec<2> stream(1, -0.5);
  s.sides[0] = {Side<2>{Kind<2>::inflow, stream}, Side<2>{Kind<2>::outflow}};
  s.sides[1] = {Side<2>{Kind<2>::outflow}, Side<2>{Kind<2>::inflow, stream}};
  WaterBox<2> box(s);
  box.flow.set_velocity([&](const Vec<2>&) { return stream; });
  for (int n = 0; n < 10; ++n) box.step(0.01, 1e-12);
  EXPECT_LE(box.error([&](int d, const Vec<2>&) { return stream[d]; }), 1e-13);
}

/// Stream of speed 1 along x with a Taylor vortex about (x0, 1/2), u_theta = s (r/a) exp(1/2 -
/// r^2/2a^2).
struct CarriedVortex {
  static constexpr double strength = 0.2, radius = 0.08;
  double x0;
  Vec<2> operator()(const Vec<2>& x) const {
    const Vec<2> r = x - Vec<2>(x0, 0.5);
    const double spin =
        strength / radius * std::exp(0.5 - 0.5 * r.squaredNorm() / (radius * radius));
    return {1 - spin * r[1], spin * r[0]};
  }
};

/// Largest departure from the stream left in the box 0.7 s after a vortex at x = 0.6 set out.
double left_behind(Kind<2> exit) {
  auto s = channel<2>(0, 0, Vec<2>(1, 0), Kind<2>::slip, 64);
  s.viscosity = 1e-3;
  s.sides[0][1] = {exit, Vec<2>(1, 0)};
  WaterBox<2> box(s);
  box.flow.set_velocity(CarriedVortex{0.6});
  for (int n = 0; n < 140; ++n) box.step(0.005, 1e-6);
  return box.error([](int d, const Vec<2>&) { return d == 0 ? 1.0 : 0.0; });
}

/// 0.8 % of the vortex is left; a side of fixed velocity keeps 37 % of it in the box.
TEST(PassingWater, VortexLeavesThroughTheOutflow) {
  const double outflow = left_behind(Kind<2>::outflow), fixed = left_behind(Kind<2>::inflow);
  EXPECT_LE(outflow, 0.02 * CarriedVortex::strength);
  EXPECT_GE(fixed, 0.2 * CarriedVortex::strength);
}

/// Entrance flow at Re 20 over a floor that reaches through inflow and outflow: u is a parabola
/// before the exit. The floor's top is at 1/4; as sharp faces see it, half a cell below.
TEST(PassingWater, ChannelFlowDevelopsIntoAParabola) {
  WaterSetup<2> s{.mesh = {Vec<2>::Zero(), Vec<2>(1.0 / 8, 1.0 / 32), {32, 40}, {}},
                  .viscosity = 0.05};
  const double inf = std::numeric_limits<double>::infinity();
  s.solids = {
      {"floor", box(Vec<3>(-inf, -inf, -inf), Vec<3>(inf, 0.25, inf)), Vec<3>::Zero(), at_rest()}};
  s.sides[0] = {Side<2>{Kind<2>::inflow, Vec<2>(1, 0)}, Side<2>{Kind<2>::outflow}};
  WaterBox<2> channel(s);
  for (int n = 0; n < 500; ++n) channel.step(0.02, 1e-13);
  EXPECT_EQ(through(channel, 0, 0), 32);
  EXPECT_NEAR(through(channel, 0, 1), 32, 32e-12);
  const double gap = 1 + 1.0 / 64;
  double largest = 0;
  channel.for_open_faces([&](int d, const Vec<2>& x, long p) {
    if (x[0] < 3.8) return;
    const double y = (1.25 - x[1]) / gap;
    const double exact = d == 0 ? 6 / gap * y * (1 - y) : 0.0;
    largest = std::max(largest, std::abs(channel.flow.velocity()[d][p] - exact));
  });
  EXPECT_LE(channel.grid.parallel().max(largest), 0.01);
}

/// Flow along the last axis round a disc or ball under App. B's sides: what the body displaces
/// passes the lateral ones, in and out, and as much leaves as enters.
template <int D, class Check>
void flow_round_a_body(int n, int steps, const Parallel& parallel, Check&& check) {
  Vec<D> stream = Vec<D>::Zero();
  stream[D - 1] = 1;
  auto s = channel<D>(D - 1, 0, stream, Kind<D>::far_field, n);
  const Shape body = D == 2 ? cylinder(0.15, -1, 1) : sphere(Vec<3>(0, 0, 0.4), 0.2);
  s.solids = {{"body", body, Vec<3>(0.5, D == 2 ? 0.4 : 0.5, 0), at_rest()}};
  WaterBox<D> box(s, parallel);
  box.flow.set_velocity([&](const Vec<D>&) { return stream; });
  for (int i = 0; i < steps; ++i) box.step(0.01, 1e-12);
  check(box);
}

TEST(PassingWater, FarFieldLetsThroughWhatADiscDisplaces) {
  flow_round_a_body<2>(32, 60, Parallel(), [](const WaterBox<2>& box) {
    const double right = through(box, 0, 1), left = -through(box, 0, 0);
    EXPECT_GT(right, 0.5);
    EXPECT_NEAR(right, left, 1e-5);  // sweeps of the viscous solve go one way
    EXPECT_NEAR(through(box, 1, 1) + right + left, through(box, 1, 0), 1e-12 * 32);
    EXPECT_LE(box.largest_divergence(), 1e-9);
  });
}

template <int D>
void expect_same_on_one_rank(int n, int steps) {
  flow_round_a_body<D>(n, steps, Parallel(MPI_COMM_SELF), [&](const WaterBox<D>& one) {
    flow_round_a_body<D>(n, steps, Parallel(), [&](const WaterBox<D>& many) {
      double difference = 0;
      for (int d = 0; d < D; ++d)
        many.for_cells([&](Index<D> c, long p) {
          for (int a = 0; a < D; ++a) c[a] += many.grid.block().offset[a];
          const double there = one.flow.velocity()[d][one.grid.block().at(c)];
          difference = std::max(difference, std::abs(many.flow.velocity()[d][p] - there));
        });
      EXPECT_LE(many.grid.parallel().max(difference), 1e-11) << D << "-D";
    });
  });
}

TEST(PassingWater, SameFlowOnAnyNumberOfRanks) {
  expect_same_on_one_rank<2>(32, 60);
  expect_same_on_one_rank<3>(16, 15);
}

/// Shear u = y passes unharmed between far fields: no viscous stress builds up at the sides, where
/// slip would flatten the profile.
TEST(PassingWater, FarFieldKeepsTheViscousStressContinuous) {
  WaterSetup<2> s{.mesh = cubic_mesh<2>(Vec<2>::Zero(), 1, 16), .viscosity = 1};
  s.mesh.periodic[0] = true;
  for (auto& side : s.sides[1]) side.kind = Kind<2>::far_field;
  WaterBox<2> box(s);
  const auto shear = [](int d, const Vec<2>& x) { return d == 0 ? x[1] : 0.0; };
  box.flow.set_velocity([](const Vec<2>& x) { return Vec<2>(x[1], 0); });
  for (int n = 0; n < 20; ++n) box.step(0.01, 1e-12);
  EXPECT_LE(box.error(shear), 1e-12);
}

TEST(PassingWater, RefusesInflowWithoutAWayOut) {
  WaterSetup<2> s{.mesh = cubic_mesh<2>(Vec<2>::Zero(), 1, 16)};
  s.sides[0][0] = {Kind<2>::inflow, Vec<2>(1, 0)};
  EXPECT_THROW(WaterBox<2>{s}, InputError);
  s.sides[0][1] = {Kind<2>::inflow, Vec<2>(1, 0)};
  EXPECT_NO_THROW(WaterBox<2>{s});
}

}  // namespace
}  // namespace washtub
