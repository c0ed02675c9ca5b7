#include "contact/untangle.hpp"

#include <gtest/gtest.h>

#include "contact/heap.hpp"
#include "contact/start_check.hpp"

using namespace washtub;
using namespace washtub::testing;

namespace {

constexpr double gap = 0.02;

template <int D>
bool anywhere(int, const Vec<D>&) {
  return true;
}

/// Whether each piece has only been moved.
template <int D>
void expect_moved_as_they_are(const Cloth<D>& before, const Cloth<D>& after) {
  for (const auto& g : after.groups)
    for (int p = 0; p < g.pieces; ++p) {
      const auto from = before.piece(g, p), to = after.piece(g, p);
      for (std::size_t i = 0; i < to.size(); ++i)
        EXPECT_LT(((to[i] - from[i]) - (to[0] - from[0])).norm(), 1e-12);
    }
}

/// A heap whose pieces have all been put into each other, the second upright.
Cloth<3> tangled_plates() {
  auto cloth = heap<3>(4, 0.005);
  for (std::size_t i = 20; i < 40; ++i) {
    Vec<3>& x = cloth.position[i];
    x = Vec<3>(x[0], x[2], x[1]);
  }
  return cloth;
}

}  // namespace

TEST(Untangle, PartsPiecesThatPassThroughEachOther) {
  auto cloth = tangled_plates();
  const auto before = cloth;
  ASSERT_TRUE(find_too_near(cloth, open_box<3>(), gap));
  EXPECT_TRUE(untangle<3>(cloth, open_box<3>(), gap, anywhere<3>));
  EXPECT_FALSE(find_too_near(cloth, open_box<3>(), gap));
  expect_moved_as_they_are(before, cloth);
}

TEST(Untangle, PartsThreads) {
  auto cloth = heap<2>(5, 0.001);
  const auto before = cloth;
  EXPECT_TRUE(untangle<2>(cloth, open_box<2>(), gap, anywhere<2>));
  EXPECT_FALSE(find_too_near(cloth, open_box<2>(), gap));
  expect_moved_as_they_are(before, cloth);
}

/// A plate stands upright through a lying one, its edge just below: it goes up by that.
TEST(Untangle, TakesTheShortWay) {
  auto cloth = heap<3>(2, 0);
  for (std::size_t i = 20; i < 40; ++i) {
    const Vec<3> flat = cloth.position[i - 20];
    cloth.position[i - 20] = Vec<3>(flat[0], flat[1], 0);
    cloth.position[i] = Vec<3>(0.1 * flat[0], 0.37 * flat[0] + 0.01, flat[1] + 0.17);
  }
  const auto before = cloth;
  ASSERT_TRUE(find_too_near(cloth, open_box<3>(), gap));
  EXPECT_TRUE(untangle<3>(cloth, open_box<3>(), gap, anywhere<3>));
  const Vec<3> way =
      (cloth.position[20] - before.position[20]) - (cloth.position[0] - before.position[0]);
  EXPECT_LT(way.norm(), 0.12);
}

/// Edges that meet exactly are no crossing, and the way between them tells nothing.
TEST(Untangle, PartsWhatMeetsExactly) {
  auto cloth = heap<3>(2, 0);
  for (std::size_t i = 0; i < 20; ++i) {
    const double x = 0.1 * static_cast<double>(i % 4), y = 0.1 * static_cast<double>(i / 4);
    cloth.position[i] = Vec<3>(x, y, 0);
    cloth.position[20 + i] = Vec<3>(x, 0.2, y - 0.1);
  }
  EXPECT_TRUE(untangle<3>(cloth, open_box<3>(), gap, anywhere<3>));
  EXPECT_FALSE(find_too_near(cloth, open_box<3>(), gap));
}

/// What crosses through a periodic side leaves through it.
TEST(Untangle, PartsAcrossPeriodicSides) {
  Mesh<2> mesh = open_box<2>();
  mesh.periodic = {true, true};
  auto cloth = heap<2>(2, 0);
  cloth.position[6 + 2] += Vec<2>(0, 0.01);  // through the first one
  cloth.position[6 + 3] -= Vec<2>(0, 0.01);
  auto across = cloth;
  for (std::size_t i = 6; i < 12; ++i) across.position[i][1] += 20;
  EXPECT_TRUE(untangle<2>(cloth, mesh, gap, anywhere<2>));
  EXPECT_TRUE(untangle<2>(across, mesh, gap, anywhere<2>));
  for (std::size_t i = 6; i < 12; ++i)
    EXPECT_LT((across.position[i] - Vec<2>(0, 20) - cloth.position[i]).norm(), 1e-9);
}

TEST(Untangle, LeavesApartWhatIsApart) {
  auto cloth = heap<3>(4, 0.05);
  const auto before = cloth;
  EXPECT_TRUE(untangle<3>(cloth, open_box<3>(), gap, anywhere<3>));
  EXPECT_EQ(cloth.position, before.position);
}

/// Pinned pieces, and those that have no room, stay; the others give way. Where none may, that is
/// said.
TEST(Untangle, MovesOnlyWhatMayMove) {
  auto cloth = heap<3>(2, 0.005);
  const auto before = cloth;
  const auto second = [](int piece, const Vec<3>&) { return piece == 1; };
  EXPECT_TRUE(untangle<3>(cloth, open_box<3>(), gap, second));
  for (std::size_t i = 0; i < 20; ++i) EXPECT_EQ(cloth.position[i], before.position[i]);
  EXPECT_FALSE(find_too_near(cloth, open_box<3>(), gap));

  auto held = before;
  held.groups[0].pinned = {0};
  EXPECT_FALSE(untangle<3>(held, open_box<3>(), gap, anywhere<3>));
}

TEST(Untangle, CannotHelpAPieceThatPassesThroughItself) {
  auto cloth = heap<2>(1, 0.1);
  cloth.position[4] = Vec<2>(0.15, 0.1);
  cloth.position[5] = Vec<2>(0.15, -0.1);
  EXPECT_FALSE(untangle<2>(cloth, open_box<2>(), gap, anywhere<2>));
}
