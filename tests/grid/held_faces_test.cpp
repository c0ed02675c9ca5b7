#include "grid/held_faces.hpp"

#include <gtest/gtest.h>

#include "grid/block.hpp"

namespace washtub {
namespace {

HeldFace face(const Block<2>& block, int i, int k, double wall) {
  HeldFace f{};
  f.p = block.at({i, k});
  f.row = block.row_index(0, k);
  f.place = i;
  f.wall = wall;
  return f;
}

/// Places in a row and velocities of what is held there.
std::vector<std::pair<int, double>> in_row(const HeldFaces& held, int row) {
  std::vector<std::pair<int, double>> found;
  held.for_row(row, [&](const HeldFace& f, int) { found.emplace_back(f.place, f.wall); });
  return found;
}

/// A face that is looked at again is held anew or no longer; the others stay. In the order of
/// memory, however often a face was looked at.
TEST(HeldFaces, TakeUpWhatIsLookedAt) {
  const Block<2> block({0, 0}, {8, 4});
  HeldFaces held(block.rows() * block.planes());
  held.hold(face(block, 5, 2, 1));
  held.hold(face(block, 2, 1, 2));
  held.hold(face(block, 3, 2, 3));
  held.update();
  EXPECT_EQ(in_row(held, 1), (std::vector<std::pair<int, double>>{{2, 2}}));
  EXPECT_EQ(in_row(held, 2), (std::vector<std::pair<int, double>>{{3, 3}, {5, 1}}));

  for (int twice = 0; twice < 2; ++twice) {
    held.look(block.at({5, 2}));
    held.look(block.at({2, 1}));
    held.hold(face(block, 5, 2, 7));
  }
  held.update();
  EXPECT_TRUE(in_row(held, 1).empty());
  EXPECT_EQ(in_row(held, 2), (std::vector<std::pair<int, double>>{{3, 3}, {5, 7}}));
  EXPECT_EQ(held.size(), 2U);
}

}  // namespace
}  // namespace washtub
