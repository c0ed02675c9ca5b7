#include "io/xdmf.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <regex>

namespace washtub {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::Not;

/// Whether every opened tag is closed in the right order and nothing else uses < or >.
bool well_formed(const std::string& xml) {
  std::vector<std::string> open;
  std::size_t at = 0;
  while ((at = xml.find_first_of("<>", at)) != std::string::npos) {
    const std::size_t end = xml.find('>', at);
    if (xml[at] == '>' || end == std::string::npos) return false;
    const std::string tag = xml.substr(at + 1, end - at - 1), name = tag.substr(0, tag.find(' '));
    at = end + 1;
    if (tag.find('<') != std::string::npos) return false;
    if (tag.front() == '?' || tag.back() == '/') continue;
    if (tag.front() != '/')
      open.push_back("/" + name);
    else if (open.empty() || open.back() != tag)
      return false;
    else
      open.pop_back();
  }
  return open.empty();
}

/// Every match of the first group.
std::vector<std::string> all(const std::string& text, const std::string& pattern) {
  const std::regex expression(pattern);
  std::vector<std::string> found;
  for (std::sregex_iterator m(text.begin(), text.end(), expression), end; m != end; ++m)
    found.push_back((*m)[1]);
  return found;
}

const FluidGrid grid = {{4, 3, 6}, {-1, -2, 0}, {0.5, 1, 0.25}};

const FrameFields fields = {{{"velocity", "velocity", "m/s", 3, ""},
                             {"pressure", "pressure", "Pa", 1, ""},
                             {"solid", "solid fraction", "", 1, ""}},
                            {{"total", "total stress", "Pa", 1, ""}}};

FrameIndex two_frames() {
  FrameIndex index;
  index.add(0.1, "frames/frame_000000.h5", grid, {6, 2, 4}, fields,
            {{"angle of a & b [rad]", 0.25}});
  index.add(0.2, "frames/frame_000001.h5", grid, {6, 2, 4}, fields,
            {{"angle of a & b [rad]", 0.5}});
  return index;
}

TEST(Xdmf, IsWellFormedFromTheFirstFrameOn) {
  EXPECT_TRUE(well_formed(FrameIndex().text()));
  const std::string text = two_frames().text();
  EXPECT_TRUE(well_formed(text));
  EXPECT_THAT(text, HasSubstr("angle of a &amp; b [rad]"));
  EXPECT_FALSE(well_formed(text.substr(0, text.size() - 5)));
}

TEST(Xdmf, OneFluidAndOneClothThroughAllTimes) {
  const std::string text = two_frames().text();
  EXPECT_THAT(all(text, "Grid Name=\"(\\w+)\" GridType=\"Collection\" CollectionType=\"Temporal\""),
              ElementsAre("fluid", "cloth"));
  EXPECT_THAT(all(text, "Grid Name=\"(\\w+)\" GridType=\"Uniform\""),
              ElementsAre("fluid", "fluid", "cloth", "cloth"));
  EXPECT_THAT(all(text, "<Time Value=\"(0\\.[12])\\d*\""), ElementsAre("0.1", "0.2", "0.1", "0.2"));
}

TEST(Xdmf, WithoutClothThereIsNoMeshOfIt) {
  FrameIndex index;
  index.add(0, "f.h5", grid, {}, fields, {});
  EXPECT_THAT(index.text(), Not(HasSubstr("cloth")));
  FrameIndex again;
  again.restore(index.text(), 1);
  EXPECT_EQ(again.text(), index.text());
}

TEST(Xdmf, ParaViewsFileIncludesAllFrames) {
  EXPECT_TRUE(well_formed(paraview_index()));
  EXPECT_THAT(paraview_index(), HasSubstr("href=\"frames.xdmf\""));
}

TEST(Xdmf, FluidIsDescribedSlowestAxisFirst) {
  FrameIndex index;
  index.add(0, "f.h5", grid, {}, fields, {});
  const std::string text = index.text();
  EXPECT_THAT(all(text, "3DCoRectMesh\" Dimensions=\"([^\"]*)\""), ElementsAre("7 4 5"));
  EXPECT_THAT(all(text, "Format=\"XML\"[^>]*>([^<]*)<"), ElementsAre("0 -2 -1", "0.25 1 0.5"));
  EXPECT_THAT(all(text, "Format=\"HDF\" Dimensions=\"([^\"]*)\""),
              ElementsAre("6 3 4 3", "6 3 4", "6 3 4"));
  EXPECT_THAT(all(text, ">(f.h5:[^<]*)<"),
              ElementsAre("f.h5:/fluid/velocity", "f.h5:/fluid/pressure", "f.h5:/fluid/solid"));
  EXPECT_THAT(all(text, "Attribute Name=\"([^\"]*)\""),
              ElementsAre("velocity [m/s]", "pressure [Pa]", "solid fraction"));
}

TEST(Xdmf, ClothIsQuadrilateralsOrLines) {
  const std::string plates = two_frames().text();
  EXPECT_THAT(plates, HasSubstr("\"Quadrilateral\" NumberOfElements=\"2\""));
  EXPECT_THAT(plates, HasSubstr("Dimensions=\"2 4\""));
  FrameIndex threads;
  threads.add(0, "f.h5", grid, {5, 3, 2}, fields, {});
  EXPECT_THAT(threads.text(),
              HasSubstr("\"Polyline\" NodesPerElement=\"2\" NumberOfElements=\"3\""));
  EXPECT_THAT(threads.text(), HasSubstr("Dimensions=\"5 3\""));
}

TEST(Xdmf, PlaneCasesAreASlabBelowTheirCloth) {
  const Mesh<2> mesh{{1, 2}, {0.1, 0.2}, {30, 40}, {}};
  const FluidGrid g = fluid_grid(mesh);
  EXPECT_THAT(g.cells, ElementsAre(30, 40, 1));
  EXPECT_TRUE(g.lower.isApprox(Vec<3>(1, 2, -0.1)));
  EXPECT_TRUE(g.spacing.isApprox(Vec<3>(0.1, 0.2, 0.1)));
}

TEST(Xdmf, RestoresWhatItWrote) {
  const std::string text = two_frames().text();
  FrameIndex all_of_it, first;
  all_of_it.restore(text, 2);
  EXPECT_TRUE(all_of_it.text() == text);
  first.restore(text, 1);
  EXPECT_EQ(first.frames(), 1);
  EXPECT_TRUE(well_formed(first.text()));
}

}  // namespace
}  // namespace washtub
