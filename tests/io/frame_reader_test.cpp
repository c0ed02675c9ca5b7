#include "io/frame_reader.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <functional>

#include "base/error.hpp"
#include "scratch.hpp"

namespace washtub {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::Not;
using ::testing::ThrowsMessage;

/// One frame of 2 x 1 x 1 cells, a cylinder of cloth with 3 x 2 nodes and a flat piece with 2 x 2.
struct Written {
  Scratch dir;
  std::string path = frame_path(dir.path(), 0);

  Written() {
    FrameWriter writer(dir.path(), Parallel(MPI_COMM_SELF), 3, {{2, 1, 1}, {0, 0, 0}, {1, 1, 1}});
    const std::vector<float> u = {1, 2, 3, 4, 5, 6}, p = {7, 8}, solid = {0, 0.25};
    std::vector<double> x, s = {1, 2, 3, 4, 5, 6};
    for (int i = 0; i < 18; ++i) x.push_back(i);
    const std::span<const double> places(x), stress(s);
    const FieldDescription velocity{"velocity", "velocity", "m/s", 3, "mean of the faces"};
    Frame frame{1.5,
                {{0, 0, 0},
                 {2, 1, 1},
                 {{velocity, u},
                  {{"salt", "salt content", "kg/m^3", 1, "dissolved"}, p},
                  {{"solid", "solid fraction", "", 1, ""}, solid}}},
                {{"heat", "temperature", "K", 1, ""}, {"total", "total stress", "Pa", 1, ""}},
                {},
                {{"the tub", 0.5}}};
    frame.cloth.push_back({{3, 2}, places, {stress, stress}, {true, false}});
    frame.cloth.push_back({{2, 2}, places.first(12), {stress.first(4), stress.first(4)}, {}});
    writer.write(frame);
  }
  void expect_failure(const std::string& what) const {
    const auto read = [&] {
      const FrameReader file(path);
      file.time();
      file.cloth();
      file.water({"velocity"});
    };
    EXPECT_THAT(read, ThrowsMessage<InputError>(HasSubstr(path + ": " + what)));
  }
  void change(const std::function<void(hid_t)>& what) const {
    const hid_t file = H5Fopen(path.c_str(), H5F_ACC_RDWR, H5P_DEFAULT);
    what(file);
    H5Fclose(file);
  }
};

TEST(FrameReader, GivesBackWhatWasWritten) {
  const Written w;
  const FrameReader file(w.path);
  EXPECT_EQ(file.time(), 1.5);
  ASSERT_EQ(file.solids().size(), 1U);
  EXPECT_EQ(file.solids()[0].name, "the tub");
  EXPECT_EQ(file.solids()[0].angle, 0.5);
  const WaterFrame water = file.water();
  EXPECT_EQ(water.cells, (std::array{2, 1, 1}));
  EXPECT_THAT(*find(water.fields, "velocity"), ElementsAre(1, 2, 3, 4, 5, 6));
  EXPECT_THAT(*find(water.fields, "solid"), ElementsAre(0, 0.25));
}

/// A field that nothing but its declaration knows comes back with all that this says of it.
TEST(FrameReader, FieldsTellWhatTheyAre) {
  const Written w;
  const FrameReader file(w.path);
  const WaterFrame water = file.water({"salt"});
  ASSERT_EQ(water.fields.size(), 1U);
  EXPECT_EQ(water.fields[0].field,
            (FieldDescription{"salt", "salt content", "kg/m^3", 1, "dissolved"}));
  EXPECT_THAT(water.fields[0].values, ElementsAre(7, 8));
  EXPECT_EQ(file.water().fields.size(), 3U);
  EXPECT_EQ(file.cloth().fields[0].field, (FieldDescription{"heat", "temperature", "K", 1, ""}));
}

TEST(FrameReader, DatasetsOfALaterVersionAreNoHindrance) {
  const Written w;
  w.change([](hid_t file) {
    H5Lcreate_hard(file, "cloth/positions", file, "cloth/normals", H5P_DEFAULT, H5P_DEFAULT);
    H5Lcreate_hard(file, "cloth/total", file, "cloth/wear", H5P_DEFAULT, H5P_DEFAULT);
  });
  const ClothFrame cloth = FrameReader(w.path).cloth();
  EXPECT_EQ(cloth.nodes(), 10U);
  EXPECT_EQ(find(cloth.fields, "normals"), nullptr);
  EXPECT_EQ(find(cloth.fields, "wear")->size(), 10U);
}

TEST(FrameReader, GivesBackTheCloth) {
  const ClothFrame cloth = FrameReader(Written().path).cloth();
  const std::array<bool, 2> round = {true, false}, flat = {false, false};
  EXPECT_THAT(cloth.pieces,
              ElementsAre(ClothFrame::Piece{0, {3, 2}, round}, ClothFrame::Piece{6, {2, 2}, flat}));
  EXPECT_EQ(cloth.positions.size(), 30U);
  EXPECT_THAT(*find(cloth.fields, "total"), ElementsAre(1, 2, 3, 4, 5, 6, 1, 2, 3, 4));
}

TEST(FrameReader, HalfAFileIsNone) {
  const Written w;
  const auto size = std::filesystem::file_size(w.path);
  for (const auto kept : {size / 2, size - 1, std::uintmax_t{100}, std::uintmax_t{0}}) {
    std::filesystem::resize_file(w.path, kept);
    w.expect_failure("is no whole frame (");
    EXPECT_THAT([&] { FrameReader{w.path}; },
                ThrowsMessage<InputError>(Not(HasSubstr("HDF5 failed"))));
  }
}

TEST(FrameReader, NamesWhatIsMissing) {
  const Written w;
  w.change([](hid_t file) { H5Ldelete(file, "fluid/velocity", H5P_DEFAULT); });
  w.expect_failure("has no dataset fluid/velocity; it may be of another version");
  w.change([](hid_t file) { H5Ldelete(file, "cloth/pieces", H5P_DEFAULT); });
  w.expect_failure("has no dataset cloth/pieces");
  w.change([](hid_t file) { H5Adelete(file, "time [s]"); });
  w.expect_failure("has no \"time [s]\"; it may be of another version");
}

TEST(FrameReader, NamesAWrongShape) {
  const Written w;
  w.change([](hid_t file) {
    H5Ldelete(file, "cloth/total", H5P_DEFAULT);
    H5Lcreate_hard(file, "cloth/piece", file, "cloth/total", H5P_DEFAULT, H5P_DEFAULT);
  });
  w.expect_failure("dataset cloth/total has 4 values for 10");
}

/// Puts three values in place of one; read into the room for one they would overwrite others.
TEST(FrameReader, AttributesHaveOneValue) {
  const Written w;
  const hsize_t three = 3;
  w.change([&](hid_t file) {
    const Hdf5Handle space(H5Screate_simple(1, &three, nullptr), H5Sclose);
    const Hdf5Handle text(H5Tcopy(H5T_C_S1), H5Tclose);
    H5Tset_size(text, 100);
    H5Adelete_by_name(file, "fluid/salt", "label", H5P_DEFAULT);
    H5Aclose(H5Acreate_by_name(file, "fluid/salt", "label", text, space, H5P_DEFAULT, H5P_DEFAULT,
                               H5P_DEFAULT));
  });
  EXPECT_EQ(FrameReader(w.path).water({"salt"}).fields[0].field.label, "salt");
  w.change([&](hid_t file) {
    const Hdf5Handle space(H5Screate_simple(1, &three, nullptr), H5Sclose);
    H5Adelete(file, "time [s]");
    H5Aclose(H5Acreate2(file, "time [s]", H5T_NATIVE_DOUBLE, space, H5P_DEFAULT, H5P_DEFAULT));
  });
  w.expect_failure("has no \"time [s]\"; it may be of another version");
}

void overwrite(hid_t file, const char* name, const std::vector<int>& values) {
  const Hdf5Handle dataset(H5Dopen2(file, name, H5P_DEFAULT), H5Dclose);
  H5Dwrite(dataset, H5T_NATIVE_INT, H5S_ALL, H5S_ALL, H5P_DEFAULT, values.data());
}

TEST(FrameReader, NamesWhatIsOutOfRange) {
  const Written w;
  w.change([](hid_t file) { overwrite(file, "cloth/cells", std::vector<int>(16, -2147483647)); });
  w.expect_failure("dataset cloth/cells names node -2147483647 of 10");
  w.change([](hid_t file) {
    overwrite(file, "cloth/pieces", {0, 2147483647, 2147483647, 6, 2, 2});
  });
  w.expect_failure("dataset cloth/pieces is damaged: more nodes than the file has bytes");
}

TEST(FrameReader, AGridThatTheFileCannotHoldIsRefused) {
  const Written w;
  w.change([](hid_t file) {
    const std::array<hsize_t, 3> n = {hsize_t{1} << 32, hsize_t{1} << 20, 2};
    const Hdf5Handle space(H5Screate_simple(3, n.data(), nullptr), H5Sclose);
    const Hdf5Handle plist(H5Pcreate(H5P_DATASET_CREATE), H5Pclose);
    H5Pset_alloc_time(plist, H5D_ALLOC_TIME_LATE);
    H5Dclose(
        H5Dcreate2(file, "fluid/air", H5T_NATIVE_FLOAT, space, H5P_DEFAULT, plist, H5P_DEFAULT));
  });
  EXPECT_THAT([&] { FrameReader(w.path).cells(); },
              ThrowsMessage<InputError>(HasSubstr("dataset fluid/air is damaged: 9.01e+15 cells")));
}

TEST(FrameFiles, AreListedWithTheirGaps) {
  const Scratch dir;
  EXPECT_TRUE(frame_files(dir.path()).numbers.empty());
  std::filesystem::create_directory(dir / "frames");
  for (const int n : {4, 0, 1}) std::ofstream(frame_path(dir.path(), n)) << "x";
  std::ofstream(dir / "frames/frame_000007.h5.part") << "x";
  for (const char* other : {"other.h5", "frame_2.h5", "frame_0000003.h5", "frame_000003.h5.h5"})
    std::ofstream(dir / (std::string("frames/") + other)) << "x";
  EXPECT_THAT(frame_files(dir.path()).numbers, ElementsAre(0, 1, 4));
  EXPECT_THAT(frame_files(dir.path()).gaps, ElementsAre(FrameGap{2, 3}));
  std::ofstream(frame_path(dir.path(), 2147483647)) << "x";
  EXPECT_THAT(frame_files(dir.path()).gaps, ElementsAre(FrameGap{2, 3}, FrameGap{5, 2147483646}));
}

}  // namespace
}  // namespace washtub
