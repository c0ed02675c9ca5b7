#include "io/cloth_mesh.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace washtub {
namespace {

using ::testing::ElementsAre;

TEST(ClothMesh, RingCloses) {
  const std::vector<double> x(6, 0.0), s(3, 0.0);
  const ClothMesh open({{{1, 3}, x, {s}, {}}}, 2);
  EXPECT_THAT(open.cells, ElementsAre(0, 1, 1, 2));
  const ClothMesh ring({{{1, 3}, x, {s}, {false, true}}}, 2);
  EXPECT_THAT(ring.cells, ElementsAre(0, 1, 1, 2, 2, 0));
  EXPECT_EQ(ring.topology.cells, 3);
  EXPECT_EQ(ring.topology.nodes, 3);
}

TEST(ClothMesh, TubeCloses) {
  const std::vector<double> x(18, 0.0), s(6, 0.0);
  const ClothMesh tube({{{2, 3}, x, {s}, {false, true}}}, 3);
  EXPECT_THAT(tube.cells, ElementsAre(0, 1, 3, 2, 2, 3, 5, 4, 4, 5, 1, 0));
}

}  // namespace
}  // namespace washtub
