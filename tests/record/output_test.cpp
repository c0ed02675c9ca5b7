#include "record/output.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <numeric>

#include "base/error.hpp"
#include "io/frame_reader.hpp"
#include "io/scratch.hpp"
#include "record/fields.hpp"
#include "record/names.hpp"
#include "record/reference.hpp"

namespace washtub {
namespace {

using ::testing::HasSubstr;

Case box() {
  Case whole;
  whole.dimension = 2;
  whole.domain.size = {1, 1, 0};
  whole.domain.cells = {16, 16, 1};
  whole.time.end = 1;
  ClothCase thread;
  thread.arrangement = Arrangement::sheet;
  thread.size = {0.4, 0};
  thread.nodes = {9, 1};
  thread.origin = {0.3, 0.5, 0};
  thread.material = {100, 0, 1e-3, 0, 0, 0, 1e-3};
  whole.cloth = {thread};
  return whole;
}

/// A run that has written its first row and frame.
struct Begun {
  explicit Begun(const Case& whole) : simulation(whole, Parallel()), observer(simulation) {
    Output<2> output(simulation, observer, folder.path());
    output.start();
    output.add_row(observer.observe());
    output.add_frame();
    output.write_summary("stopped", 1);
  }
  Scratch folder;
  Simulation<2> simulation;
  Observer<2> observer;
};

/// Whatever is declared of a field is in the frame, in its index and in the documents.
TEST(Output, OneDeclarationOfAFieldIsSeenEverywhere) {
  const Begun run(box());
  const FrameReader frame(frame_path(run.folder.path(), 0));
  const std::string index = contents(run.folder / "frames.xdmf"), page = output_reference();
  const auto water = frame.water();
  const auto cloth = frame.cloth();
  const auto expect = [&](const auto& stored, const FieldDescription& field) {
    EXPECT_THAT(index, HasSubstr("\"" + heading(field) + "\""));
    EXPECT_THAT(page, HasSubstr("/" + field.name + "` | " + field.label));
    for (const auto& one : stored.fields)
      if (one.field == field) return;
    ADD_FAILURE() << field.name;
  };
  for (const auto& declared : water_fields<2>()) expect(water, declared.field);
  for (const auto& declared : cloth_fields<2>()) expect(cloth, declared.field);
  EXPECT_EQ(water.fields.size(), water_fields<2>().size());
}

/// A velocity beyond what 32 bits can hold.
TEST(Output, NoFrameHoldsWhatIsNotFinite) {
  Case whole = box();
  whole.fluid.velocity = {"1e39", "0", "0"};
  EXPECT_THAT([&] { Begun run(whole); },
              ::testing::ThrowsMessage<RunError>(HasSubstr(
                  "t = 0 s: the field velocity of the water is not finite everywhere, so that its "
                  "frame was not written; try a smaller time.step")));
}

/// At the very start there are no statistics, but a summary that says so.
TEST(Output, SummaryOfARunThatHasHardlyBegun) {
  const Begun run(box());
  const std::string text = contents(run.folder / "summary.json");
  EXPECT_THAT(text, HasSubstr("\"mean [Pa]\": null"));
  EXPECT_EQ(text.find("nan"), std::string::npos);
  EXPECT_EQ(text.find("inf"), std::string::npos);
}

/// The value `solid` of every cell of a unit square of 32 x 32 cells with this solid in it.
std::vector<float> solid_of(const Shape& shape, Mapping mapping) {
  Case whole;
  whole.dimension = 2;
  whole.domain.size = {1, 1, 0};
  whole.domain.cells = {32, 32, 1};
  whole.domain.mapping = mapping;
  whole.time.end = 1;
  whole.solids = {{"body", shape, Vec<3>::Zero(), at_rest()}};
  const Scratch folder;
  Simulation<2> simulation(whole, Parallel());
  Observer<2> observer(simulation);
  Output<2>(simulation, observer, folder.path()).add_frame();
  for (const auto& field : FrameReader(frame_path(folder.path(), 0)).water().fields)
    if (field.field.name == names::solid) return field.values;
  return {};
}

/// A square that covers 8 x 8 cells, but not quite: 6 x 6 of them have no open face.
TEST(Output, SolidIsWhereNoWaterCanEnter) {
  const Shape square = washtub::box({0.251, 0.251, -1}, {0.499, 0.499, 1});
  const auto solid = solid_of(square, Mapping::sharp);
  EXPECT_EQ(std::accumulate(solid.begin(), solid.end(), 0.0F), 36);
  EXPECT_EQ(solid[9 + 32 * 9], 1);
  EXPECT_EQ(solid[8 + 32 * 9], 0);
}

/// Cells at a smooth floor are as open as their upper faces: H of Eq. (11), two cells wide.
TEST(Output, SolidFollowsTheMostOpenFace) {
  const Shape floor = half_space({0, 0.25, 0}, {0, 1, 0});
  const auto solid = solid_of(floor, Mapping::smooth);
  for (std::size_t j = 5; j <= 9; ++j) {
    const double psi = (0.25 - static_cast<double>(j + 1) / 32) * 16;  // in gamma
    const double inside = 0.5 * (1 + psi + std::sin(std::numbers::pi * psi) / std::numbers::pi);
    EXPECT_NEAR(solid[16 + 32 * j], std::clamp(std::abs(psi) < 1 ? inside : psi, 0.0, 1.0), 1e-6)
        << j;
  }
}

}  // namespace
}  // namespace washtub
