#include <gtest/gtest.h>

#include "cloth/crossings.hpp"
#include "cloth/plate.hpp"
#include "coupling/pool.hpp"

using namespace washtub;
using namespace washtub::testing;

namespace {

/// A force on each node of the first half and of the second half, along the last axis [N].
template <int D>
class Push : public NodalForce<D> {
 public:
  Push(double first, double second) : force_{first, second} {}
  void add(const ClothMoment<D>&, std::vector<Vec<D>>& force) override {
    for (std::size_t i = 0; i < force.size(); ++i)
      force[i][D - 1] += force_[2 * i < force.size() ? 0 : 1];
  }

 private:
  std::array<double, 2> force_;
};

/// The least distance between the nodes of the two pieces.
template <int D>
double least_distance(const Cloth<D>& cloth) {
  double least = 1e30;
  const std::size_t n = cloth.position.size() / 2;
  for (std::size_t i = 0; i < n; ++i)
    for (std::size_t j = n; j < 2 * n; ++j)
      least = std::min(least, (cloth.position[i] - cloth.position[j]).norm());
  return least;
}

/// Two pieces, the second over the first, less than two cells apart.
Cloth<2> two_threads() {
  std::vector<Vec<2>> where;
  for (int p = 0; p < 2; ++p)
    for (int i = 0; i < 9; ++i) where.emplace_back(0.3 + 0.05 * i, 0.48 + 0.05 * p);
  Cloth<2> cloth;
  cloth.add(make_thread(9, 0.05, {2e3, 0, 1e-2, 0, 0, 0.5, 1e-3}), where);
  return cloth;
}

/// Six pieces on each other, much nearer than the water tells apart, that lean by a node.
Cloth<2> stack(double friction) {
  constexpr double h = 1.0 / 32;
  std::vector<Vec<2>> where;
  for (int p = 0; p < 6; ++p)
    for (int i = 0; i < 9; ++i) where.emplace_back(0.3 + 0.05 * i + 0.01 * p, 0.5 + 0.15 * h * p);
  Material material{2e3, 0, 1e-2, 0, 0, 0.5, 1e-3};
  material.friction = friction;
  Cloth<2> cloth;
  cloth.add(make_thread(9, 0.05, material), where);
  return cloth;
}

Cloth<3> two_plates() {
  std::vector<Vec<3>> where;
  for (int p = 0; p < 2; ++p)
    for (int n = 0; n < 25; ++n)
      where.emplace_back(0.3 + 0.1 * (n % 5), 0.3 + 0.1 * (n / 5), 0.45 + 0.1 * p);
  Cloth<3> cloth;
  cloth.add(make_plate({5, 5}, {0.1, 0.1}, {2e3, 100, 1e-2, 1e-2, 0, 0.5, 1e-3}), where);
  return cloth;
}

/// In a grid of cells h: with a gap far larger than the default.
ContactSettings layers(double h, double pressure) {
  return {ContactScheme::layers, 1.5 * h, pressure, 0, 0.8 * h, 1000 * 8.0 / 3 * h, 6e-3};
}

template <int D>
struct Pressed {
  Pool<D> pool;
  Crossings worst;
  int held = 0;

  Pressed(const Mesh<D>& mesh, const Cloth<D>& cloth, double force, Scheme scheme,
          const ContactSettings& contact, const Parallel& parallel = Parallel())
      : pool(mesh, 1, cloth, scheme, parallel, contact) {
    pool.coupling.add(std::make_unique<Push<D>>(force, -force));
  }
  void run(int steps, double dt) {
    for (int i = 0; i < steps; ++i) {
      held += pool.step(dt).contact.held;
      const auto found = find_crossings(pool.cloth, pool.water.grid.mesh());
      worst.others = std::max(worst.others, found.others);
    }
  }
};

Mesh<3> cube() { return cubic_mesh<3>({0, 0, 0}, 1, 16, true); }

}  // namespace

/// Pressed onto each other, sheets come as near as the water between lets them; with contact the
/// implicit scheme keeps the gap, and all the forces between them are no momentum.
TEST(VerificationContactInWater, KeepsTheGapBetweenSheets) {
  constexpr double h = 1.0 / 32, gap = 0.8 * h, impulse = 300 * 9 * 0.4;
  const auto press = [](const ContactSettings& contact) {
    Pressed<2> pressed(square(), two_threads(), 300, Scheme::implicit, contact);
    pressed.run(400, 1e-3);
    EXPECT_EQ(pressed.worst.others, 0);
    EXPECT_LT(pressed.pool.momentum().norm(), 1e-5 * impulse);
    return std::pair(least_distance(pressed.pool.cloth), pressed.held);
  };
  EXPECT_LT(press({}).first, 0.8 * gap);
  const auto [held_distance, held] = press(layers(h, 0));
  EXPECT_GT(held_distance, 0.9 * gap);
  EXPECT_GT(held, 0);
  const auto [repelled_distance, held_then] = press(layers(h, 2e5));
  EXPECT_GT(repelled_distance, 1.05 * gap);
  EXPECT_LT(held_then, held);
}

/// Of the force on the water about y = 0, along y [N m].
double first_moment(const WaterBox<2>& water) {
  double sum = 0;
  for_face_cells(water.grid, [&](int d, long p, const Index<2>& cell) {
    if (d == 1) sum += water.flow.force()[1][p] * water.grid.mesh().position(cell, 1)[1];
  });
  return water.grid.parallel().sum(sum) * water.grid.mesh().cell_volume();
}

/// Sheets that are held apart hand what presses them to each other, not to the water.
TEST(ContactInWater, TheWaterIsSparedWhatSheetsCarry) {
  constexpr double load = 300, distance = 0.05;
  ContactSettings contact = layers(1.0 / 32, 0);
  contact.gap = distance;
  Pressed<2> pressed(square(), two_threads(), load, Scheme::implicit, contact);
  double mean = 0;
  for (int i = 0; i < 400; ++i) {
    pressed.run(1, 1e-3);
    mean += first_moment(pressed.pool.water) / 400;
  }
  EXPECT_LT(std::abs(mean), 0.3 * 9 * load * distance);
}

/// A thread that is pressed on the floor hands that to the floor: the water has none of it.
TEST(ContactInWater, TheWaterIsSparedWhatTheFloorCarries) {
  constexpr double h = 1.0 / 32, load = 100;
  WaterBox<2> water({cubic_mesh<2>({0, 0}, 1, 32), {}, 1000, 1});
  std::vector<Vec<2>> where;
  for (int i = 0; i < 9; ++i) where.emplace_back(0.3 + 0.05 * i, 0.501 * h);
  Cloth<2> cloth;
  cloth.add(make_thread(9, 0.05, {2e3, 0, 1e-2, 0, 0, 0.5, 1e-3}), where);
  Coupling<2> coupling(water.flow, cloth, water.mapping, Kernel::cosine, {}, Scheme::implicit);
  coupling.add(std::make_unique<Push<2>>(-load, -load));
  double mean = 0;
  for (int i = 0; i < 400; ++i) {
    water.move_solids(1e-3);
    water.flow.predict(1e-3);
    coupling.push();
    water.flow.project(1e-6, 60);
    EXPECT_FALSE(coupling.again());
    coupling.move();
    mean += total<2>(water.grid, water.flow.force())[1] / 400;
  }
  EXPECT_LT(std::abs(mean), 0.1 * 9 * load);
}

TEST(VerificationContactInWater, KeepsTheGapBetweenPlates) {
  constexpr double h = 1.0 / 16;
  Pressed<3> kept(cube(), two_plates(), 100, Scheme::implicit, layers(h, 0));
  kept.run(200, 2e-3);
  EXPECT_EQ(kept.worst.others, 0);
  EXPECT_GT(kept.held, 0);
  EXPECT_GT(least_distance(kept.pool.cloth), 0.9 * 0.8 * h);
  EXPECT_LT(kept.pool.momentum().norm(), 1e-5 * 100 * 25 * 0.4);
}

TEST(VerificationContactInWater, RepelsInEveryScheme) {
  constexpr double h = 1.0 / 32;
  for (const Scheme scheme : {Scheme::implicit, Scheme::explicit_euler, Scheme::broyden}) {
    Pressed<2> none(square(), two_threads(), 300, scheme, {});
    Pressed<2> kept(square(), two_threads(), 300, scheme, layers(h, 2e5));
    none.run(300, 1e-3);
    kept.run(300, 1e-3);
    EXPECT_GT(least_distance(kept.pool.cloth), least_distance(none.pool.cloth) + 0.1 * h);
  }
}

/// Sheets that the water does not tell apart go with it, whatever the friction between them: it
/// does not feed on the motion that it makes itself.
TEST(ContactInWater, FrictionInAPackedStackMakesNoMotion) {
  constexpr double h = 1.0 / 32;
  const auto slip = [](double friction) {
    ContactSettings contact = layers(h, 300);
    contact.gap = 0.1 * h;
    Pressed<2> pressed(square(), stack(friction), 3, Scheme::implicit, contact);
    double sum = 0;
    for (int i = 0; i < 200; ++i) sum += pressed.pool.step(1e-3).slip;
    return sum;
  };
  EXPECT_LT(slip(0.5), 1.2 * slip(0));
}

/// On all ranks together the same as on each alone.
TEST(ContactInWater, DoesNotDependOnRanks) {
  constexpr double h = 1.0 / 16;
  const ContactSettings contact = layers(h, 1000);
  Pressed<3> together(cube(), two_plates(), 100, Scheme::implicit, contact);
  Pressed<3> alone(cube(), two_plates(), 100, Scheme::implicit, contact, Parallel(MPI_COMM_SELF));
  for (auto* pressed : {&together, &alone}) pressed->run(90, 2e-3);
  EXPECT_GT(together.held, 0);
  EXPECT_EQ(together.held, alone.held);
  for (int i = 0; i < 50; ++i)
    EXPECT_LT((together.pool.cloth.position[i] - alone.pool.cloth.position[i]).norm(), 1e-6);
}
