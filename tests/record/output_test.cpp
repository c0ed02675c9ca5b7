#include "record/output.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "base/error.hpp"
#include "io/frame_reader.hpp"
#include "io/scratch.hpp"
#include "record/fields.hpp"
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

/// The water's velocity is 1/0.
TEST(Output, NoFrameHoldsWhatIsNotFinite) {
  Case whole = box();
  whole.fluid.velocity = {"1/(x - x)", "0", "0"};
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

}  // namespace
}  // namespace washtub
