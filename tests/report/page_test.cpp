#include "report/page.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "base/error.hpp"
#include "io/frame_reader.hpp"
#include "page_folder.hpp"

namespace washtub {
namespace {

using ::testing::Contains;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using testing::MadeFrames;
using testing::ReadPage;
using testing::RunFolder;
using Json = nlohmann::ordered_json;

constexpr std::size_t plenty = 20'000'000;

constexpr const char* plane_case = R"(dimension = 2
[washer]
radius = "0.5 m"
stroke = { kind = "sinusoid", peak = "2 rad/s", frequency = "1 Hz" }
[fluid]
viscosity = "1 Pa s"
[domain]
cells = 32
[time]
end = "4 s"
[output]
every = "0.1 s"
window = ["1 s", "4 s"]
)";

/// A run of which only case, history and frames are real, and its page.
struct Made : MadeFrames {
  RunFolder folder;
  std::string directory = folder.path("run");

  explicit Made(const MadeFrames& frames = {}, const std::string& text = RunFolder::case_text())
      : MadeFrames(frames) {
    folder.run("run", {}, text);
    if (count > 0) MadeFrames::write(directory);
  }
  std::string file(int frame) const { return frame_path(directory, frame); }
  PageSize make(std::size_t limit = plenty) const {
    return write_page(folder.path("page.html"), {"washtub test", {read_run(directory)}, nullptr},
                      limit);
  }
  ReadPage page(std::size_t limit = plenty) const {
    make(limit);
    return ReadPage(folder.path("page.html"));
  }
};

std::vector<std::string> notes(const ReadPage& page) { return page.run()["notes"]; }

TEST(Page, HoldsTheClothAsItWasWritten) {
  const Made made;
  const ReadPage page = made.page();
  const Json& frames = page.frames();
  EXPECT_EQ(frames["times"], Json({0.0, 0.5, 1.0, 1.5, 2.0}));
  EXPECT_EQ(frames["angles"]["agitator"][2], 0.2);
  EXPECT_EQ(page.run()["cloth"]["pieces"][1],
            Json({{"first", 12}, {"nr", 3}, {"ns", 4}, {"closed", {false, false}}}));
  const auto q = page.chunk<std::uint16_t>(frames["positions"]);
  const auto s = page.chunk<std::uint16_t>(frames["stress"]["total"]["values"]);
  ASSERT_EQ(q.size(), 5U * 3 * 24);
  const double largest = frames["stress"]["total"]["largest"];
  EXPECT_EQ(largest, made.stress(4, 23));
  for (std::size_t f = 0; f < 5; ++f)
    for (std::size_t n = 0; n < 24; ++n) {
      for (std::size_t d = 0; d < 3; ++d) {
        const double low = frames["span"]["lower"][d], high = frames["span"]["upper"][d];
        EXPECT_NEAR(low + q[(3 * f + d) * 24 + n] * (high - low) / 65535,
                    made.position(int(f), n, int(d)), 0.51 * (high - low) / 65535);
      }
      const double root = std::sqrt(made.stress(int(f), n) / largest);
      EXPECT_NEAR(s[f * 24 + n] / 65535.0, root, 0.51 / 65535);
    }
}

TEST(Page, HoldsTheWaterAsItWasWritten) {
  const Made made;
  const ReadPage page = made.page();
  const Json& fields = page.frames()["fields"];
  EXPECT_EQ(fields["cells"], Json({16, 16, 16}));
  EXPECT_EQ(fields["frames"], Json({0, 1, 2, 3, 4}));
  EXPECT_TRUE(fields["vorticity"].is_null());
  const auto q = page.chunk<std::int8_t>(fields["velocity"]["values"]);
  ASSERT_EQ(q.size(), 5 * 3 * made.size());
  const double largest = fields["velocity"]["largest"][3];
  for (std::size_t d = 0; d < 3; ++d)
    for (std::size_t c = 0; c < made.size(); ++c) {
      const double u = made.velocity(3, c, d), root = std::sqrt(std::abs(u) / largest);
      ASSERT_NEAR(q[(9 + d) * made.size() + c] / 127.0, std::copysign(root, u), 0.51 / 127);
    }
  const auto solid = page.chunk<std::uint8_t>(fields["solid"]);
  EXPECT_EQ(solid[0], 255);
  EXPECT_EQ(solid[1], 0);
}

TEST(Page, HoldsTextsAndSolids) {
  const Made made;
  const ReadPage page = made.page();
  const auto history = page.chunk<char>(page.run()["history"]);
  EXPECT_EQ(std::string(history.begin(), history.end()), contents(made.directory + "/history.csv"));
  ASSERT_EQ(page.run()["solids"].size(), 2U);
  const Json& agitator = page.run()["solids"][1];
  EXPECT_EQ(agitator["name"], "agitator");
  EXPECT_EQ(agitator["moving"], true);
  const auto triangles = page.chunk<std::uint32_t>(agitator["triangles"]);
  const auto vertices = page.chunk<float>(agitator["vertices"]);
  EXPECT_GT(triangles.size(), 3000U);
  EXPECT_EQ(3 * (1 + *std::max_element(triangles.begin(), triangles.end())), vertices.size());
  EXPECT_EQ(page.run()["free_surface"], true);
  EXPECT_EQ(page.run()["frames"]["angles"].size(), 1U);
}

TEST(Page, OfAPlaneCaseHasVorticity) {
  MadeFrames frames{2, {32, 32, 1}, 2, true, {1, 7}};
  const Made made(frames, plane_case);
  const ReadPage page = made.page();
  EXPECT_EQ(page.run()["dimension"], 2);
  const Json& fields = page.frames()["fields"];
  EXPECT_EQ(fields["cells"], Json({32, 32, 1}));
  EXPECT_EQ(page.chunk<std::int8_t>(fields["velocity"]["values"]).size(), 2U * 2 * 1024);
  const auto w = page.chunk<std::int8_t>(fields["vorticity"]["values"]);
  ASSERT_EQ(w.size(), 2U * 1024);
  const double h = fields["spacing"][0], largest = fields["vorticity"]["largest"][1];
  const std::size_t at = 5 + 32 * 9;
  const double expected = (made.velocity(1, at + 1, 1) - made.velocity(1, at - 1, 1)) / (2 * h) -
                          (made.velocity(1, at + 32, 0) - made.velocity(1, at - 32, 0)) / (2 * h);
  EXPECT_NEAR(w[1024 + at] / 127.0,
              std::copysign(std::sqrt(std::abs(expected) / largest), expected), 0.51 / 127);
  EXPECT_LT(page.run()["box"]["lower"][2].get<double>(), 0);
  EXPECT_EQ(page.run()["box"]["upper"][2], 0);
}

TEST(Page, WithoutClothHasNone) {
  MadeFrames frames;
  frames.cloth = false;
  const Made made(frames);
  const ReadPage page = made.page();
  EXPECT_TRUE(page.run()["cloth"].is_null());
  EXPECT_TRUE(page.frames()["positions"].is_null());
  EXPECT_TRUE(page.frames()["stress"].is_null());
  EXPECT_EQ(page.frames()["fields"]["frames"].size(), 5U);
}

TEST(Page, WithoutFramesSaysWhy) {
  MadeFrames none;
  none.count = 0;
  const ReadPage unwanted = Made(none, plane_case).page();
  EXPECT_THAT(notes(unwanted), Contains(HasSubstr("output.frames is 0")));
  EXPECT_TRUE(unwanted.frames()["times"].empty());
  const Made wanted(none, std::string(plane_case) + "frames = \"1 s\"\n");
  EXPECT_THAT(notes(wanted.page()), Contains("There are no frames yet, only curves."));
}

TEST(Page, LeavesBrokenFramesOut) {
  const Made made;
  std::filesystem::resize_file(made.file(1), std::filesystem::file_size(made.file(1)) / 2);
  std::filesystem::remove(made.file(2));
  MadeFrames other;
  other.nodes = {4, 4};
  other.count = 1;
  const RunFolder elsewhere;
  std::filesystem::create_directories(elsewhere.path("other"));
  other.write(elsewhere.path("other"));
  std::filesystem::rename(frame_path(elsewhere.path("other"), 0), made.file(3));
  const ReadPage page = made.page();
  EXPECT_EQ(page.frames()["times"], Json({0.0, 2.0}));
  EXPECT_THAT(notes(page), Contains(HasSubstr("frames 1, 3: " + made.file(1))));
  EXPECT_THAT(notes(page), Contains("Missing: frame 2."));
}

TEST(Page, OfAnotherGridShowsTheClothOnly) {
  MadeFrames frames;
  frames.cells = {8, 8, 8};
  const ReadPage page = Made(frames).page();
  EXPECT_TRUE(page.frames()["fields"].is_null());
  EXPECT_EQ(page.frames()["times"].size(), 5U);
  EXPECT_THAT(notes(page), Contains(HasSubstr("other cells than case.toml")));
}

TEST(Page, WithoutACaseShowsTheCloth) {
  const Made made;
  std::filesystem::remove(made.directory + "/case.toml");
  const ReadPage page = made.page();
  EXPECT_EQ(page.frames()["times"].size(), 5U);
  EXPECT_TRUE(page.run()["solids"].empty());
}

TEST(Page, KeepsWithinEveryPossibleSize) {
  MadeFrames frames;
  frames.count = 12;
  const Made made(frames);
  const std::size_t whole = made.make().bytes;
  const int chunk = made.page().frames()["fields"]["velocity"]["values"];
  const std::size_t water = made.page().element("washtub-chunk-" + std::to_string(chunk)).size();
  ASSERT_GT(water, 100000U);
  for (const std::size_t limit : {whole, whole - water / 3, whole - water, whole - water - 2500}) {
    const PageSize size = made.make(limit);
    EXPECT_LE(size.bytes, limit);
    EXPECT_EQ(std::filesystem::file_size(made.folder.path("page.html")), size.bytes);
  }
  EXPECT_THAT(notes(made.page(whole)), ElementsAre());
  EXPECT_THAT(notes(made.page(whole - water / 3)), ElementsAre("6 of 12 frames carry the water."));
}

TEST(Page, TooSmallASizeNamesTheSmallest) {
  const Made made;
  EXPECT_THAT([&] { made.make(1000); },
              ::testing::ThrowsMessage<InputError>(HasSubstr("the smallest possible page has")));
  EXPECT_FALSE(std::filesystem::exists(made.folder.path("page.html")));
}

TEST(Page, TextsCannotEndItsScript) {
  const Made made({}, "title = \"</script><b>\"\n" + RunFolder::case_text().substr(18));
  const ReadPage page = made.page();
  EXPECT_EQ(page.run()["title"], "</script><b>");
}

}  // namespace
}  // namespace washtub
