#include "io/frame.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/resource.h>

#include <csignal>

#include "base/error.hpp"
#include "scratch.hpp"

namespace washtub {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::Not;

const FluidGrid grid = {{4, 3, 6}, {-1, -2, 0}, {0.5, 1, 0.25}};

/// Value of a cell from its global position, so that a wrong order shows.
float value_at(int i, int j, int k) { return static_cast<float>(i + 10 * j + 100 * k); }

/// This rank's share of the grid, in slabs of z, and a flat plate of 3 x 2 nodes.
struct Sample {
  const FieldDescription velocity_field{"velocity", "velocity", "m/s", 3, "of the water"};
  const FieldDescription pressure_field{"pressure", "pressure", "Pa", 1, ""};
  const FieldDescription solid_field{"solid", "solid fraction", "", 1, ""};
  std::vector<float> velocity, pressure, solid;
  std::vector<double> positions, membrane, bending, total;
  Frame frame;

  Sample(const Parallel& p, double time) {
    const int first = 6 * p.rank() / p.size(), last = 6 * (p.rank() + 1) / p.size();
    for (int k = first; k < last; ++k)
      for (int j = 0; j < 3; ++j)
        for (int i = 0; i < 4; ++i) {
          for (int d = 0; d < 3; ++d)
            velocity.push_back(value_at(i, j, k) + 0.25f * static_cast<float>(d));
          pressure.push_back(-value_at(i, j, k));
          solid.push_back(i == 0 ? 1 : 0);
        }
    for (int n = 0; n < 6; ++n) positions.insert(positions.end(), {n % 3 + 0., n / 3 + 0., 0.5});
    membrane = {1, 2, 3, 4, 5, 6};
    bending.assign(6, 0.5);
    for (const double m : membrane) total.push_back(m + 0.5);
    frame = {time,
             {{0, 0, first},
              {4, 3, last - first},
              {{velocity_field, velocity}, {pressure_field, pressure}, {solid_field, solid}}},
             {{"membrane", "membrane stress", "Pa", 1, ""},
              {"bending", "bending stress", "Pa", 1, ""},
              {"total", "total stress", "Pa", 1, ""}},
             {{{3, 2}, positions, {membrane, bending, total}, {}}},
             {{"agitator", 2 * time}}};
  }
};

template <class T>
std::vector<T> read(const std::string& file, const char* name, hid_t type) {
  const hid_t f = H5Fopen(file.c_str(), H5F_ACC_RDONLY, H5P_DEFAULT);
  const hid_t d = H5Dopen2(f, name, H5P_DEFAULT), space = H5Dget_space(d);
  std::vector<T> values(static_cast<std::size_t>(H5Sget_simple_extent_npoints(space)));
  H5Dread(d, type, H5S_ALL, H5S_ALL, H5P_DEFAULT, values.data());
  H5Sclose(space);
  H5Dclose(d);
  H5Fclose(f);
  return values;
}

double read_attribute(const std::string& file, const char* name) {
  double value = 0;
  const hid_t f = H5Fopen(file.c_str(), H5F_ACC_RDONLY, H5P_DEFAULT);
  const hid_t a = H5Aopen(f, name, H5P_DEFAULT);
  H5Aread(a, H5T_NATIVE_DOUBLE, &value);
  H5Aclose(a);
  H5Fclose(f);
  return value;
}

struct Written {
  Parallel parallel;
  Scratch dir{Scratch::For::all_ranks};
  FrameWriter writer{dir.path(), parallel, 3, grid};
  Written() {
    for (const double t : {0.25, 0.5, 0.75}) writer.write(Sample(parallel, t).frame);
  }
  std::string file(const char* name) const { return dir / ("frames/" + std::string(name)); }
};

TEST(Frame, EveryCellComesBackWhateverTheRanks) {
  const Written w;
  const auto u = read<float>(w.file("frame_000001.h5"), "fluid/velocity", H5T_NATIVE_FLOAT);
  const auto p = read<float>(w.file("frame_000001.h5"), "fluid/pressure", H5T_NATIVE_FLOAT);
  ASSERT_EQ(u.size(), 3 * 72);
  ASSERT_EQ(p.size(), 72);
  for (int k = 0, n = 0; k < 6; ++k)
    for (int j = 0; j < 3; ++j)
      for (int i = 0; i < 4; ++i, ++n) {
        EXPECT_EQ(p[n], -value_at(i, j, k));
        EXPECT_EQ(u[3 * n + 2], value_at(i, j, k) + 0.5f);
      }
}

TEST(Frame, ClothTimeAndAnglesComeBack) {
  const Written w;
  const std::string file = w.file("frame_000002.h5");
  EXPECT_THAT(read<int>(file, "cloth/cells", H5T_NATIVE_INT), ElementsAre(0, 1, 4, 3, 1, 2, 5, 4));
  EXPECT_THAT(read<int>(file, "cloth/pieces", H5T_NATIVE_INT), ElementsAre(0, 3, 2));
  EXPECT_THAT(read<double>(file, "cloth/total", H5T_NATIVE_DOUBLE),
              ElementsAre(1.5, 2.5, 3.5, 4.5, 5.5, 6.5));
  const auto x = read<double>(file, "cloth/positions", H5T_NATIVE_DOUBLE);
  ASSERT_EQ(x.size(), 18);
  EXPECT_THAT(std::vector<double>(x.begin() + 12, x.begin() + 15), ElementsAre(1, 1, 0.5));
  EXPECT_EQ(read_attribute(file, "time [s]"), 0.75);
  EXPECT_EQ(read_attribute(file, "angle of agitator [rad]"), 1.5);
}

TEST(Frame, OnlyFinishedFilesRemain) {
  const Written w;
  MPI_Barrier(MPI_COMM_WORLD);
  EXPECT_EQ(w.dir.entries(), 3);  // frames, frames.xdmf, paraview.xdmf2
  EXPECT_EQ(std::distance(std::filesystem::directory_iterator(w.dir / "frames"), {}), 3);
}

TEST(Frame, ThreadsInThePlaneBecomeLinesAtZeroHeight) {
  const Parallel parallel;
  const Scratch dir(Scratch::For::all_ranks);
  FrameWriter writer(dir.path(), parallel, 2, {{1, 1, 1}, {0, 0, -1}, {1, 1, 1}});
  const std::vector<float> value(parallel.root() ? 1 : 0);
  const std::vector<double> x = {1, 2, 3, 4, 5, 6}, y = {7, 8, 9, 10}, s = {1, 2, 3};
  const std::span<const double> two(s.data(), 2);
  const int n = parallel.root();
  writer.write({1,
                {{0, 0, 0}, {n, n, n}, {{{"salt", "salt", "kg/m^3", 1, ""}, value}}},
                {{"total", "total stress", "Pa", 1, ""}},
                {{{1, 3}, x, {s}, {}}, {{1, 2}, y, {two}, {}}},
                {}});
  const std::string file = dir / "frames/frame_000000.h5";
  EXPECT_THAT(read<double>(file, "cloth/positions", H5T_NATIVE_DOUBLE),
              ElementsAre(1, 2, 0, 3, 4, 0, 5, 6, 0, 7, 8, 0, 9, 10, 0));
  EXPECT_THAT(read<int>(file, "cloth/cells", H5T_NATIVE_INT), ElementsAre(0, 1, 1, 2, 3, 4));
  EXPECT_THAT(read<int>(file, "cloth/piece", H5T_NATIVE_INT), ElementsAre(0, 0, 1));
}

TEST(Frame, MissingDirectoryIsReportedOnAllRanks) {
  const std::string expected = "cannot write /nowhere/frames: No such file or directory";
  EXPECT_THAT([] { FrameWriter("/nowhere", Parallel(), 3, grid); },
              ::testing::ThrowsMessage<RunError>(expected));
}

TEST(Frame, FailedWriteLeavesNothingAndTheRunCanGoOn) {
  Written w;
  const std::string target = w.file("frame_000003.h5");
  if (w.parallel.root()) std::filesystem::create_directories(target + "/blocks");
  MPI_Barrier(MPI_COMM_WORLD);
  const Sample sample(w.parallel, 1);
  EXPECT_THAT([&] { w.writer.write(sample.frame); },
              ::testing::ThrowsMessage<RunError>(HasSubstr("cannot write " + target)));
  EXPECT_FALSE(std::filesystem::exists(target + ".part"));
  EXPECT_THAT(contents(w.dir / "frames.xdmf"), Not(HasSubstr("frame_000003")));
  MPI_Barrier(MPI_COMM_WORLD);
  if (w.parallel.root()) std::filesystem::remove_all(target);
  w.writer.write(sample.frame);
  EXPECT_EQ(w.writer.frames(), 4);
}

/// Until the end of its life no file can grow beyond `bytes`, as on a full disk.
class FullDisk {
 public:
  explicit FullDisk(rlim_t bytes) : handler_(std::signal(SIGXFSZ, SIG_IGN)) {
    getrlimit(RLIMIT_FSIZE, &before_);
    const rlimit limit = {bytes, before_.rlim_max};
    setrlimit(RLIMIT_FSIZE, &limit);
  }
  ~FullDisk() {
    setrlimit(RLIMIT_FSIZE, &before_);
    std::signal(SIGXFSZ, handler_);
  }

 private:
  void (*handler_)(int);
  rlimit before_{};
};

TEST(Frame, FullDiskIsReportedAndLeavesNothing) {
  Written w;
  const Sample sample(w.parallel, 1);
  {
    const FullDisk full(1000);
    EXPECT_THAT([&] { w.writer.write(sample.frame); },
                ::testing::ThrowsMessage<RunError>(
                    HasSubstr("cannot write " + w.file("frame_000003.h5:"))));
  }
  EXPECT_FALSE(std::filesystem::exists(w.file("frame_000003.h5.part")));
  EXPECT_FALSE(std::filesystem::exists(w.file("frame_000003.h5")));
  EXPECT_EQ(w.writer.frames(), 3);
  MPI_Barrier(MPI_COMM_WORLD);
  w.writer.write(sample.frame);
}

TEST(Frame, WrongSizesAreNamed) {
  Written w;
  Sample sample(w.parallel, 1);
  sample.frame.fluid.fields[1].values = {};
  EXPECT_THAT([&] { w.writer.write(sample.frame); },
              ::testing::ThrowsMessage<RunError>(HasSubstr("fluid/pressure: 0 values for")));
}

TEST(Frame, ResumeForgetsLaterFrames) {
  const Written w;
  FrameWriter again(w.dir.path(), w.parallel, 3, grid);
  again.resume(2);
  EXPECT_EQ(again.frames(), 2);
  again.write(Sample(w.parallel, 0.625).frame);
  EXPECT_EQ(read_attribute(w.file("frame_000002.h5"), "time [s]"), 0.625);
  const std::string index = contents(w.dir / "frames.xdmf");
  EXPECT_THAT(index, HasSubstr("<Time Value=\"0.625\"/>"));
  EXPECT_THAT(index, Not(HasSubstr("<Time Value=\"0.75\"/>")));
}

}  // namespace
}  // namespace washtub
