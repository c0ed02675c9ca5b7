#include "coupling/markers.hpp"

#include <gtest/gtest.h>

#include "cloth/plate.hpp"
#include "cloth/thread.hpp"

using namespace washtub;

namespace {

constexpr Material soft{10, 1, 1e-3, 1e-3, 0, 0, 1e-3};

/// Two pieces of 4 x 3 nodes at spacings 0.1 and 0.2, flat.
Cloth<3> plates() {
  const auto sheet = make_plate({4, 3}, {0.1, 0.2}, soft);
  std::vector<Vec<3>> where;
  for (int p = 0; p < 2; ++p)
    for (int j = 0; j < 3; ++j)
      for (int i = 0; i < 4; ++i) where.emplace_back(0.1 * i, 0.2 * j, p);
  Cloth<3> cloth;
  cloth.add(sheet, where);
  return cloth;
}

Cloth<2> thread() {
  std::vector<Vec<2>> where;
  for (int i = 0; i < 5; ++i) where.emplace_back(0.1 * i, 0);
  Cloth<2> cloth;
  cloth.add(make_thread(5, 0.1, soft), where);
  return cloth;
}

/// A thread and a plate that go on beyond their last nodes, and a ring of four nodes.
Cloth<2> periodic_thread() {
  std::vector<Vec<2>> where;
  for (int i = 0; i < 5; ++i) where.emplace_back(0.1 * i, 0);
  Cloth<2> cloth;
  cloth.add(make_thread(5, 0.1, soft, true, {0.5, 0}), where);
  return cloth;
}

Cloth<3> periodic_plate() {
  std::vector<Vec<3>> where;
  for (int j = 0; j < 3; ++j)
    for (int i = 0; i < 4; ++i) where.emplace_back(0.1 * i, 0.2 * j, 0.7);
  Cloth<3> cloth;
  cloth.add(
      make_plate({4, 3}, {0.1, 0.2}, soft, {true, true}, {Vec<3>(0.4, 0, 0), Vec<3>(0, 0.6, 0)}),
      where);
  return cloth;
}

Cloth<2> ring() {
  Cloth<2> cloth;
  cloth.add(make_thread(4, 0.1, soft, true),
            std::vector<Vec<2>>{{0.1, 0}, {0, 0.1}, {-0.1, 0}, {0, -0.1}});
  return cloth;
}

template <int D>
void expect_shares_of_one(const Cloth<D>& cloth, const Markers<D>& markers) {
  std::vector<double> sum(cloth.position.size(), 0);
  for (int m = 0; m < markers.count(); ++m) {
    double shape = 0;
    for (int c = 0; c < Markers<D>::corners; ++c) {
      sum[markers.nodes(m)[c]] += markers.share(m)[c];
      shape += markers.shape(m)[c];
      EXPECT_GE(markers.share(m)[c], 0);
    }
    EXPECT_NEAR(shape, 1, 1e-14);
  }
  for (const double s : sum) EXPECT_NEAR(s, 1, 1e-14);
}

}  // namespace

TEST(Markers, AreTheNodesWhereTheseAreCloseEnough) {
  const auto cloth = plates();
  const Markers<3> markers(cloth, 0.2);
  ASSERT_EQ(markers.count(), 24);
  for (int m = 0; m < 24; ++m)
    EXPECT_LT((markers.position(m, cloth.position) - cloth.position[m]).norm(), 1e-15);
}

TEST(Markers, CutEachDirectionAsFinelyAsNeeded) {
  EXPECT_EQ(Markers<3>(plates(), 0.1).count(), 2 * 4 * 5);
  EXPECT_EQ(Markers<3>(plates(), 0.09).count(), 2 * 7 * 7);
  EXPECT_EQ(Markers<2>(thread(), 0.034).count(), 13);
}

TEST(Markers, ShareThemselvesOut) {
  for (const double spacing : {1.0, 0.1, 0.07, 0.031}) {
    expect_shares_of_one(plates(), Markers<3>(plates(), spacing));
    expect_shares_of_one(thread(), Markers<2>(thread(), spacing));
    expect_shares_of_one(ring(), Markers<2>(ring(), spacing));
    expect_shares_of_one(periodic_thread(), Markers<2>(periodic_thread(), spacing));
    expect_shares_of_one(periodic_plate(), Markers<3>(periodic_plate(), spacing));
  }
}

TEST(Markers, LieBetweenTheirNodesAndNeverBetweenPieces) {
  const auto cloth = plates();
  const Markers<3> markers(cloth, 0.03);
  for (int m = 0; m < markers.count(); ++m) {
    const Vec<3> x = markers.position(m, cloth.position);
    EXPECT_TRUE(x[2] == 0 || std::abs(x[2] - 1) < 1e-14);
    for (int c = 0; c < 4; ++c) {
      if (markers.shape(m)[c] == 0) continue;
      const Vec<3> gap = (x - cloth.position[markers.nodes(m)[c]]).cwiseAbs();
      EXPECT_LT(gap[0], 0.1);
      EXPECT_LT(gap[1], 0.2);
    }
  }
}

TEST(Markers, HaveTheirCentreInTheNodeExceptOnTheBorder) {
  const auto cloth = thread();
  const Markers<2> markers(cloth, 0.05);  // two to an interval
  std::vector<Vec<2>> centre(5, Vec<2>::Zero());
  for (int m = 0; m < markers.count(); ++m)
    for (int c = 0; c < 2; ++c)
      centre[markers.nodes(m)[c]] += markers.share(m)[c] * markers.position(m, cloth.position);
  for (int i = 1; i < 4; ++i) EXPECT_NEAR(centre[i][0], 0.1 * i, 1e-15);
  EXPECT_NEAR(centre[0][0], 0.1 / 6, 1e-15);  // half a weight at half an interval, out of 1.5
}

TEST(Markers, LieAcrossTheSeamOfARing) {
  const auto cloth = ring();
  const Markers<2> markers(cloth, 0.05);  // two to an interval
  ASSERT_EQ(markers.count(), 8);
  EXPECT_LT((markers.position(7, cloth.position) - Vec<2>(0.05, -0.05)).norm(), 1e-15);
}

/// Every node of a sheet without borders is the mean of its markers, seen from where it stands.
template <int D>
void expect_centres(const Cloth<D>& cloth, double spacing, int count) {
  const Markers<D> markers(cloth, spacing);
  EXPECT_EQ(markers.count(), count);
  const auto& sheet = cloth.groups[0].sheet;
  std::vector<Vec<D>> offset(cloth.position.size(), Vec<D>::Zero());
  for (int m = 0; m < markers.count(); ++m) {
    const Vec<D> x = markers.position(m, cloth.position);
    for (int c = 0; c < Markers<D>::corners; ++c) {
      Vec<D> away = x - cloth.position[markers.nodes(m)[c]];
      for (int d = 0; d < 2; ++d)
        if (sheet.closed[d])
          away -= std::round(away.dot(sheet.period[d]) / sheet.period[d].squaredNorm()) *
                  sheet.period[d];
      EXPECT_LT(away.norm(), sheet.spacing[0] + sheet.spacing[1] + 1e-14);
      offset[markers.nodes(m)[c]] += markers.share(m)[c] * away;
    }
  }
  for (const auto& o : offset) EXPECT_LT(o.norm(), 1e-14);
}

TEST(Markers, HaveTheirCentreInTheNodeWhereThereIsNoBorder) {
  expect_centres(periodic_thread(), 0.034, 15);
  expect_centres(periodic_plate(), 0.09, 8 * 9);
}
