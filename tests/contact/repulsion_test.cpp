#include "contact/repulsion.hpp"

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <functional>

#include "contact/heap.hpp"

using namespace washtub;
using namespace washtub::testing;

namespace {

constexpr double range = 0.05, pressure = 400, dt = 1e-3;

ContactSettings settings(double areal_mass = 1e6) {
  return {ContactScheme::layers, range, pressure, 0, 0.005, areal_mass, 0};
}

template <int D>
std::vector<Vec<D>> force(const Cloth<D>& cloth, double friction, double areal_mass = 1e6,
                          const Mesh<D>& mesh = open_box<D>()) {
  const ClothSurface<D> surface(cloth);
  Repulsion<D> repulsion(surface, mesh, Parallel(), settings(areal_mass), {{friction}});
  std::vector<Vec<D>> F(cloth.position.size(), Vec<D>::Zero());
  repulsion.add({cloth.position, cloth.velocity, dt}, F);
  return F;
}

double turn(const Vec<2>& x, const Vec<2>& f) { return x[0] * f[1] - x[1] * f[0]; }
Vec<3> turn(const Vec<3>& x, const Vec<3>& f) { return x.cross(f); }
double size(double moment) { return std::abs(moment); }
double size(const Vec<3>& moment) { return moment.norm(); }

template <int D>
Cloth<D> shaken_heap() {
  auto cloth = heap<D>(6, 0.02);
  const auto ways = random_ways<D>(cloth.position.size(), 0.008, 1);
  cloth.velocity = random_ways<D>(cloth.position.size(), 1, 2);
  for (std::size_t i = 0; i < ways.size(); ++i) cloth.position[i] += ways[i];
  return cloth;
}

template <int D>
void expect_balance(double friction) {
  const auto cloth = shaken_heap<D>();
  const auto F = force(cloth, friction);
  Vec<D> sum = Vec<D>::Zero();
  auto moment = turn(Vec<D>(Vec<D>::Zero()), sum);
  double all = 0;
  for (std::size_t i = 0; i < F.size(); ++i) {
    sum += F[i];
    moment += turn(cloth.position[i], F[i]);
    all += F[i].norm();
  }
  EXPECT_GT(all, 1);
  EXPECT_LT(sum.norm(), 1e-14 * all);
  // Normal forces act along the line between the points; friction across a gap turns the pair.
  EXPECT_LT(size(moment), friction == 0 ? 1e-14 * all : 0.1 * all);
}

/// Two parallel plates or threads, the second `gap` above the first.
template <int D>
Cloth<D> two(double gap) {
  auto cloth = heap<D>(2, gap);
  const auto n = cloth.position.size() / 2;
  for (std::size_t i = 0; i < n; ++i) {
    cloth.position[n + i] = cloth.position[i];
    cloth.position[n + i][D - 1] += gap;
  }
  return cloth;
}

template <int D>
double total(const std::vector<Vec<D>>& F, int component) {
  double sum = 0;
  for (std::size_t i = F.size() / 2; i < F.size(); ++i) sum += F[i][component];
  return sum;
}

double law(double d) { return pressure * (1 - d / range) * (1 - d / range) * range / d; }

}  // namespace

TEST(Repulsion, AddsUpToNothing) {
  for (const double friction : {0.0, 0.4}) {
    expect_balance<2>(friction);
    expect_balance<3>(friction);
  }
}

TEST(Repulsion, IsItsPressureTimesTheArea) {
  for (const double d : {0.005, 0.02, 0.04}) {
    EXPECT_NEAR(total<3>(force(two<3>(d), 0), 2), law(d) * 0.3 * 0.4, 1e-9 * law(d));
    EXPECT_NEAR(total<2>(force(two<2>(d), 0), 1), law(d) * 0.5, 1e-9 * law(d));
  }
  for (const auto& f : force(two<3>(1.01 * range), 0)) EXPECT_EQ(f, Vec<3>::Zero());
}

/// No steeper than a quarter of areal mass over dt^2.
TEST(Repulsion, GoesOnLinearlyBelowItsKnee) {
  constexpr double mass = 0.1, slope = 0.25 * mass / (dt * dt), area = 0.12;
  const double at1 = total<3>(force(two<3>(0.002), 0, mass), 2) / area;
  const double at2 = total<3>(force(two<3>(0.004), 0, mass), 2) / area;
  EXPECT_NEAR((at1 - at2) / 0.002, slope, 1e-6 * slope);
  EXPECT_LT(at1, law(0.002));
  EXPECT_NEAR(total<3>(force(two<3>(0.04), 0, mass), 2) / area, law(0.04), 1e-6);
}

/// Coulomb's friction against the motion; where that would more than stop the sheets, less.
TEST(Repulsion, RubsAgainstSliding) {
  auto cloth = two<3>(0.01);
  for (std::size_t i = 20; i < 40; ++i) cloth.velocity[i] = Vec<3>(0.3, 0.4, -0.1);
  const auto F = force(cloth, 0.4);
  const double normal = law(0.01) * 0.12;
  EXPECT_NEAR(total<3>(F, 2), normal, 1e-9);
  EXPECT_NEAR(total<3>(F, 0), -0.4 * 0.6 * normal, 1e-9);
  EXPECT_NEAR(total<3>(F, 1), -0.4 * 0.8 * normal, 1e-9);
  constexpr double mass = 0.01;  // the least that stops: 2 sides, a tenth each
  EXPECT_NEAR(total<3>(force(cloth, 0.4, mass), 0), -2 * 0.1 * 0.12 * mass * 0.3 / dt, 1e-9);
}

/// The sheet between shields the outer two from each other.
TEST(Repulsion, IsNotFeltThroughASheet) {
  auto cloth = heap<3>(3, 0.01);
  for (std::size_t i = 0; i < 20; ++i)
    for (std::size_t p = 1; p < 3; ++p)
      cloth.position[20 * p + i] = cloth.position[i] + Vec<3>(0, 0, 0.01 * static_cast<double>(p));
  const auto F = force(cloth, 0);
  double top = 0;
  for (std::size_t i = 40; i < 60; ++i) top += F[i][2];
  EXPECT_NEAR(top, law(0.01) * 0.12, 1e-9);
}

/// A thread in the shape of a hairpin is pushed open.
TEST(Repulsion, ActsBetweenPartsOfOnePiece) {
  std::vector<Vec<2>> hairpin;
  for (int i = 0; i < 12; ++i) hairpin.emplace_back(0.1 * (i < 6 ? i : 11 - i), i < 6 ? 0.0 : 0.02);
  Cloth<2> folded;
  folded.add(make_thread(12, 0.1, {100, 0, 1e-3, 0, 0, 0, 1e-3}), hairpin);
  const auto F = force(folded, 0);
  EXPECT_LT(F[0][1], -1);
  EXPECT_GT(F[11][1], 1);
}

/// A thread of short edges has others within the range of each, and does not feel them; the last
/// edge of a ring is as near to the first as any two neighbours are.
TEST(Repulsion, DoesNotSeeNeighboursAlongTheCloth) {
  constexpr int nodes = 48;
  constexpr double spacing = 0.4 * range, radius = nodes * spacing / (2 * M_PI);
  for (const bool closed : {false, true}) {
    std::vector<Vec<2>> where;
    for (int i = 0; i < nodes; ++i) {
      const double angle = 2 * M_PI * i / nodes;
      where.push_back(closed ? Vec<2>(radius * std::cos(angle), radius * std::sin(angle))
                             : Vec<2>(spacing * i, 0));
    }
    Cloth<2> cloth;
    cloth.add(make_thread(nodes, spacing, {100, 0, 1e-3, 0, 0, 0, 1e-3}, closed), where);
    for (const auto& f : force(cloth, 0)) EXPECT_EQ(f, Vec<2>::Zero());
  }
}

/// Across a periodic side the same as in the middle of the box.
TEST(Repulsion, ReachesAcrossPeriodicSides) {
  Mesh<3> mesh = open_box<3>();
  mesh.periodic = {true, true, true};
  auto cloth = two<3>(0.02);
  const auto inside = force(cloth, 0, 1e6, mesh);
  for (std::size_t i = 0; i < 20; ++i) cloth.position[i][2] += 20;
  const auto across = force(cloth, 0, 1e6, mesh);
  for (std::size_t i = 0; i < inside.size(); ++i)
    EXPECT_LT((inside[i] - across[i]).norm(), 1e-9 * pressure);
  EXPECT_GT(total<3>(across, 2), 1);
}

/// Whatever has moved since the lists were made, the force is that of a fresh look.
void expect_no_lists(Cloth<3> cloth, int steps, const std::function<void(Cloth<3>&, int)>& move) {
  const ClothSurface<3> surface(cloth);
  const std::vector<std::vector<double>> friction(cloth.groups.size(),
                                                  std::vector<double>(cloth.groups.size(), 0.4));
  Repulsion<3> kept(surface, open_box<3>(), Parallel(), settings(), friction);
  for (int step = 0; step < steps; ++step) {
    move(cloth, step);
    std::vector<Vec<3>> F(cloth.position.size(), Vec<3>::Zero());
    kept.add({cloth.position, cloth.velocity, dt}, F);
    std::vector<Vec<3>> fresh(F.size(), Vec<3>::Zero());
    Repulsion<3>(surface, open_box<3>(), Parallel(), settings(), friction)
        .add({cloth.position, cloth.velocity, dt}, fresh);
    for (std::size_t i = 0; i < F.size(); ++i)
      ASSERT_LT((F[i] - fresh[i]).norm(), 1e-10 * pressure) << step;
  }
}

TEST(Repulsion, DoesNotDependOnItsLists) {
  expect_no_lists(shaken_heap<3>(), 30, [](Cloth<3>& cloth, int step) {
    const auto ways =
        random_ways<3>(cloth.position.size(), 0.001, 7 + static_cast<std::uint64_t>(step));
    for (std::size_t i = 0; i < ways.size(); ++i) cloth.position[i] += ways[i];
  });
}

/// A piece, small against the range, turns over between two others, which so change sides; nearer
/// to one of them, so that it never is as far from both.
TEST(Repulsion, SeesWhatChangesSides) {
  const Material material{100, 10, 1e-3, 1e-3, 0, 0, 1e-3};
  const Vec<3> centre(0.0137, 0.0093, 0.0175);
  Cloth<3> cloth;
  const auto add = [&](double spacing, const Vec<3>& middle) {
    const auto sheet = make_plate({9, 9}, {spacing, spacing}, material);
    std::vector<Vec<3>> where;
    for (int n = 0; n < sheet.nodes(); ++n)
      where.push_back(middle + spacing * Vec<3>(n % 9 - 4, n / 9 - 4, 0));
    cloth.add(sheet, where);
  };
  add(0.012, Vec<3>(0, 0, 0));
  add(0.012, Vec<3>(0, 0, 0.04));
  add(0.001, centre);
  expect_no_lists(cloth, 50, [&](Cloth<3>& moved, int) {
    const Eigen::AngleAxisd turn(0.04, Vec<3>(1, 0.3, 0).normalized());
    for (std::size_t i = 162; i < 243; ++i)
      moved.position[i] = centre + turn * (moved.position[i] - centre);
  });
}
