#include "cloth/worst_edge.hpp"

#include <gtest/gtest.h>

#include "sheets.hpp"

namespace washtub {
namespace {

/// Two pieces of a group, flat and unstrained.
template <int D>
Cloth<D> two_pieces(const Sheet<D>& sheet) {
  Cloth<D> cloth;
  std::vector<Vec<D>> X = testing::flat(sheet);
  X.insert(X.end(), X.begin(), X.end());
  cloth.add(sheet, X);
  return cloth;
}

TEST(WorstEdge, OfClothAtRestIsUnstrained) {
  EXPECT_NEAR(worst_edge(two_pieces(testing::plate(0))).strain, 0, 1e-14);
  EXPECT_EQ(worst_edge(Cloth<2>()).strain, 0);
}

TEST(WorstEdge, StretchedThread) {
  Cloth<2> cloth = two_pieces(testing::thread());
  cloth.position[9 + 8][0] += 0.02;  // the last of nine nodes 0.1 m apart, of the second piece
  const WorstEdge edge = worst_edge(cloth);
  EXPECT_NEAR(edge.strain, (1.2 * 1.2 - 1) / 2, 1e-12);
  EXPECT_NEAR(edge.elongation(), 0.2, 1e-12);
  EXPECT_EQ(edge.piece, 1);
  EXPECT_EQ(edge.node, (std::array{0, 7}));
}

/// Two edges shorter by 30 % count for more than one longer by 20 %.
TEST(WorstEdge, ShortenedPlate) {
  Cloth<3> cloth = two_pieces(testing::plate(0.3));
  for (int j = 0; j < 4; ++j) cloth.position[static_cast<std::size_t>(5 * j)][0] += 0.03;
  for (int j = 0; j < 4; ++j) cloth.position[static_cast<std::size_t>(5 * j + 4)][0] += 0.02;
  const WorstEdge edge = worst_edge(cloth);
  EXPECT_NEAR(edge.strain, (0.49 - 1) / 2, 1e-12);
  EXPECT_NEAR(edge.elongation(), -0.3, 1e-12);
  EXPECT_EQ(edge.piece, 0);
  EXPECT_EQ(edge.node[0], 0);
}

/// The edge that closes a ring, and one across a periodic side.
TEST(WorstEdge, AcrossSeams) {
  const Sheet<2> ring = testing::ring();
  EXPECT_NEAR(worst_edge(two_pieces(ring)).strain, 0, 1e-12);
  Cloth<2> cloth = two_pieces(testing::periodic_thread());
  cloth.position[8][0] -= 0.01;  // 0.09 m from node 7, 0.11 m from the image of node 0
  const WorstEdge edge = worst_edge(cloth);
  EXPECT_NEAR(edge.elongation(), 0.1, 1e-12);
  EXPECT_EQ(edge.node, (std::array{0, 8}));
}

}  // namespace
}  // namespace washtub
