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

/// Text that takes its room in every page of a case.
std::string long_comment() {
  std::string text;
  for (int i = 0; i < 30000; ++i) text += fmt::format("# {}\n", i * i % 99991);
  return text;
}

/// Two groups of one piece each; one without pieces is none.
TEST(Page, NamesTheGroupsOfCloth) {
  const std::string one =
      "size = [\"0.1 m\", \"0.1 m\"]\nfabric = \"denim\"\nnodes = [5, 5]\n[[cloth]]\n";
  std::string text = RunFolder::case_text();
  const std::string first = "[[cloth]]\n";
  text.replace(text.find(first), first.size(),
               first + "name = \"towels\"\n" + one + "name = \"none\"\ncount = 0\n" + one);
  const Made made({}, text);
  const ReadPage page = made.page();
  const Json& groups = page.run()["cloth"]["groups"];
  ASSERT_EQ(groups.size(), 2U);
  EXPECT_EQ(groups[0], Json({{"name", "towels"}, {"pieces", 1}}));
  EXPECT_EQ(groups[1], Json({{"name", "cloth 3"}, {"pieces", 1}}));
}

TEST(Page, HoldsTheClothAsItWasWritten) {
  const Made made;
  const ReadPage page = made.page();
  const Json& frames = page.frames();
  EXPECT_EQ(frames["times"], Json({0.0, 0.5, 1.0, 1.5, 2.0}));
  EXPECT_EQ(frames["angles"]["agitator"][2], 0.2);
  EXPECT_EQ(page.run()["cloth"]["pieces"][1],
            Json({{"first", 12}, {"nr", 3}, {"ns", 4}, {"closed", {false, false}}}));
  EXPECT_EQ(page.run()["cloth"]["groups"].size(), 1U);
  EXPECT_EQ(page.run()["cloth"]["groups"][0]["pieces"], page.run()["cloth"]["pieces"].size());
  const auto q = page.chunk<std::uint16_t>(frames["positions"]);
  const auto s = page.chunk<std::uint16_t>(frames["stress"]["total"]["values"]);
  ASSERT_EQ(q.size(), 5U * 3 * 24);
  const double largest = frames["stress"]["total"]["largest"];
  EXPECT_EQ(frames["stress"]["total"]["label"], "total stress");
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
  ASSERT_EQ(fields["scalars"].size(), 1U);
  EXPECT_EQ(fields["scalars"][0]["label"], "pressure");
  EXPECT_EQ(fields["scalars"][0]["unit"], "Pa");
  EXPECT_EQ(page.chunk<std::int8_t>(fields["scalars"][0]["values"]).size(), 5 * made.size());
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

TEST(VerificationPageSize, KeepsWithinEveryPossibleSize) {
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
  EXPECT_THAT(notes(made.page(whole - water / 3)), ElementsAre("7 of 12 frames carry the water."));
  EXPECT_EQ(made.page(whole - water / 3).frames()["fields"]["frames"],
            Json({0, 2, 4, 6, 8, 10, 11}));
}

/// Rows of noise, which zlib cannot make small.
std::string long_table(int rows, int seed) {
  std::string text = "time [s],a,b,c,d\n";
  for (int i = 0; i < rows; ++i) {
    text += fmt::format("{}", i);
    for (int j = 1; j <= 4; ++j) text += fmt::format(",{:.9g}", std::sin(seed + i * (j + 0.1 * i)));
    text += '\n';
  }
  return text;
}

TEST(VerificationPageSize, ThinsTheCurvesOfLongRuns) {
  MadeFrames none;
  none.count = 0;
  const Made made(none);
  const std::size_t small = made.make().bytes;
  made.folder.write("run/tracks.csv", long_table(5000, 1));
  made.folder.write("run/history.csv", long_table(4000, 2));
  const std::size_t tracks = made.page().element("washtub-chunk-5").size();
  ASSERT_GT(tracks, 150000U);
  const ReadPage some = made.page(made.make().bytes - tracks / 2);
  EXPECT_THAT(notes(some), Contains("Curves of the pieces: 1 of 4 rows is kept."));
  const auto text = some.chunk<char>(some.run()["tracks"]);
  const std::string kept(text.begin(), text.end());
  EXPECT_EQ(std::count(kept.begin(), kept.end(), '\n'), 1 + 1250 + 1);
  EXPECT_THAT(kept, ::testing::StartsWith("time [s],a,b,c,d\n0,"));
  EXPECT_THAT(kept, HasSubstr("\n4996,"));
  EXPECT_THAT(kept, HasSubstr("\n4999,"));
  const ReadPage few = made.page(small + 25000);
  EXPECT_THAT(notes(few), Contains(HasSubstr("Curves: 1 of ")));
}

TEST(VerificationPageSize, LeavesTheFramesOutAtLast) {
  MadeFrames many;
  many.nodes = {60, 60};
  const Made made(many);
  const PageSize whole = made.make();
  std::string problem;
  try {
    made.make(1000);
  } catch (const InputError& error) {
    problem = error.what();
  }
  const auto at = problem.find("page has ");
  ASSERT_NE(at, std::string::npos);
  const auto least = static_cast<std::size_t>(std::stod(problem.substr(at + 9)) * 1e6);
  EXPECT_LT(least, whole.bytes);
  const ReadPage page = made.page(least);
  EXPECT_TRUE(page.frames()["times"].empty());
  EXPECT_THAT(notes(page), Contains("The frames are left out to keep the page small."));
}

/// One run needs much at least, the other nearly nothing; either may come first.
TEST(VerificationPageSize, OfSeveralRunsFitsWhereverItCan) {
  const Made big;
  MadeFrames none;
  none.count = 0;
  const Made small(none);
  big.folder.write("run/case.toml", long_comment() + RunFolder::case_text());
  const std::string path = big.folder.path("both.html");
  for (const auto& [first, second] : {std::pair(&big, &small), std::pair(&small, &big)}) {
    const PageContent content{
        "washtub test", {read_run(first->directory), read_run(second->directory)}, nullptr};
    std::string problem;
    try {
      write_page(path, content, 1000);
    } catch (const InputError& error) {
      problem = error.what();
    }
    const auto least =
        static_cast<std::size_t>(std::stod(problem.substr(problem.find("page has ") + 9)) * 1e6);
    for (const std::size_t limit : {least, least + 20000, least + 200000})
      EXPECT_LE(write_page(path, content, limit).bytes, limit);
  }
}

TEST(Page, LeavesFramesOfLostClothOut) {
  const Made made;
  const hid_t file = H5Fopen(made.file(3).c_str(), H5F_ACC_RDWR, H5P_DEFAULT);
  const hid_t data = H5Dopen2(file, "cloth/positions", H5P_DEFAULT);
  const std::vector<double> lost(3 * 24, std::nan(""));
  H5Dwrite(data, H5T_NATIVE_DOUBLE, H5S_ALL, H5S_ALL, H5P_DEFAULT, lost.data());
  H5Dclose(data);
  H5Fclose(file);
  const ReadPage page = made.page();
  EXPECT_EQ(page.frames()["times"], Json({0.0, 0.5, 1.0, 2.0}));
  EXPECT_THAT(notes(page), Contains(HasSubstr("its cloth is at places that are not finite")));
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
