#include "washer/packet.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "base/error.hpp"
#include "contact/start_check.hpp"
#include "washer/build.hpp"
#include "washer/placement.hpp"

using namespace washtub;
using ::testing::HasSubstr;

namespace {

/// A load of real laundry in a tub of 31 cm, two groups.
Case load(const std::vector<std::string>& settings = {}) {
  return read_case_text(R"(
[washer]
radius = "31 cm"
depth = "30 cm"
[fluid]
viscosity = "1 Pa s"
[domain]
cells = 32
[[cloth]]
name = "towels"
count = 3
fabric = "terry towel"
size = ["50 cm", "80 cm"]
[[cloth]]
name = "shirts"
count = 5
fabric = "polyester shirt"
size = ["40 cm", "40 cm"]
[time]
end = "1 s"
)",
                        "load", settings);
}

/// Largest part by which an edge along r or s is not as long as at rest.
double worst_strain(const Packet& packet, const ClothCase& cloth, const Case& whole) {
  const auto nodes = cloth_nodes(cloth, whole);
  const auto step = cloth_spacing(cloth, whole);
  double worst = 0;
  const auto at = [&](int i, int j) {
    return packet.nodes[static_cast<std::size_t>(i + nodes[0] * j)];
  };
  for (int j = 0; j < nodes[1]; ++j)
    for (int i = 0; i < nodes[0]; ++i) {
      if (i + 1 < nodes[0])
        worst = std::max(worst, std::abs((at(i + 1, j) - at(i, j)).norm() / step[0] - 1));
      if (j + 1 < nodes[1])
        worst = std::max(worst, std::abs((at(i, j + 1) - at(i, j)).norm() / step[1] - 1));
    }
  return worst;
}

}  // namespace

TEST(Packet, FoldsWithoutStretching) {
  Case whole = load();
  ClothCase towel = whole.cloth[0];
  for (const std::array<int, 2> folded : {std::array{1, 4}, std::array{2, 1}, std::array{3, 1}}) {
    towel.folded = folded;
    const Packet packet = make_packet(towel, whole, 0);
    EXPECT_LT(worst_strain(packet, towel, whole), 1e-12);
    for (std::size_t d = 0; d < 2; ++d) {
      const auto layers = folded[d];
      EXPECT_GT(packet.size[d], 0.95 * towel.size[d] / layers);
      EXPECT_LT(packet.size[d], towel.size[d] / layers + 1.1 * cloth_spacing(towel, whole)[d]);
    }
  }
  towel.folded = {2, 3};
  EXPECT_LT(worst_strain(make_packet(towel, whole, 0), towel, whole), 0.05);
}

TEST(Packet, CrumplesWithoutMuchStretching) {
  Case whole = load();
  ClothCase shirt = whole.cloth[1];
  shirt.folded = {1, 1};
  shirt.crumpled = 0.3;
  const Packet one = make_packet(shirt, whole, 0), other = make_packet(shirt, whole, 1);
  EXPECT_LT(worst_strain(one, shirt, whole), 0.05);
  EXPECT_LT(one.size[0] * one.size[1], 0.85 * 0.4 * 0.4);
  EXPECT_GT(one.thickness, 0.02);
  EXPECT_GT((one.nodes[5] - other.nodes[5]).norm(), 1e-3);
  EXPECT_EQ(make_packet(shirt, whole, 1).nodes[5], other.nodes[5]);
}

/// Whether folded along one edge or both, no part starts nearer to another than the gap; and every
/// node of every piece is in the tub.
TEST(Packet, StartsInTheTubApartFromAll) {
  for (const auto& settings :
       {std::vector<std::string>{},
        {"cloth[2].arrangement=random", "cloth[2].folded=[2, 2]", "cloth[1].count=0",
         "cloth[2].count=2", "cloth[2].size=[\"28 cm\", \"28 cm\"]"},
        {"cloth[2].arrangement=random", "cloth[2].crumpled=0.2", "cloth[1].count=0",
         "cloth[2].count=2", "cloth[2].nodes=[9, 9]", "cloth[2].size=[\"18 cm\", \"18 cm\"]"}}) {
    const Case whole = load(settings);
    const auto cloth = build_cloth<3>(whole);  // refuses what is tangled
    ASSERT_GE(cloth.pieces(), 2);
    for (const auto& x : cloth.position) {
      EXPECT_LT(x.head<2>().norm(), 0.31);
      EXPECT_GT(x[2], 0);
      EXPECT_LT(x[2], 0.30);
    }
    EXPECT_FALSE(find_too_near(cloth, build_mesh<3>(whole), whole.contact.gap));
  }
}

/// What is larger than a page starts in layers, and that is said.
TEST(Packet, IsMadeOfPiecesThatOutgrowThePage) {
  const Case whole = load();
  EXPECT_EQ(whole.cloth[0].arrangement, Arrangement::layers);
  EXPECT_EQ(whole.cloth[0].folded, (std::array{1, 4}));
  ASSERT_EQ(whole.notes.size(), 2U);
  EXPECT_THAT(whole.notes[0], HasSubstr("towels: pieces of 0.5 x 0.8 m are larger than a page"));
  EXPECT_EQ(load({"cloth[1].size=[\"10 cm\", \"10 cm\"]"}).cloth[0].arrangement, Arrangement::book);
  // Written out, it is the same case, without a note.
  const Case again = read_case_text(whole.resolved, "again");
  EXPECT_EQ(again.resolved, whole.resolved);
  EXPECT_TRUE(again.notes.empty());
}

TEST(Packet, CannotBeMadeOfAFewNodes) {
  const auto error = [](const std::vector<std::string>& settings) {
    try {
      build_cloth<3>(load(settings));
      return std::string();
    } catch (const InputError& e) {
      return std::string(e.what());
    }
  };
  EXPECT_THAT(error({"cloth[1].folded=[8, 8]"}), HasSubstr("cloth.folded: 8 layers are too many"));
  EXPECT_THAT(
      error({"cloth[2].crumpled=0.6", "cloth[2].arrangement=random", "cloth[2].nodes=[5, 5]"}),
      HasSubstr("cannot be bent as sharply as that"));
}
