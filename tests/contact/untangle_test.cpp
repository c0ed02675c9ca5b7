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
