#include "io/checkpoint.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>

#include "base/error.hpp"
#include "base/snapshot.hpp"
#include "grid/grid.hpp"
#include "scratch.hpp"

namespace washtub {
namespace {

using ::testing::HasSubstr;
using ::testing::SizeIs;
using ::testing::ThrowsMessage;
namespace fs = std::filesystem;

enum class Mood { calm, wild };

/// Something with a state of every kind that an archive knows.
template <int D>
struct Thing {
  explicit Thing(const Grid<D>& grid_) : grid(grid_) {
    for (auto& f : fields) f = grid.make_field();
    owner = Storage<std::uint8_t>(fields[0].size());
  }
  /// Values that tell the place; ghosts beyond the sides of the box too, and others wrong.
  void fill(double scale) {
    const auto& b = grid.block();
    for (auto& f : fields) f.fill(-1);
    const int j0 = D == 3 ? -1 : 0, j1 = D == 3 ? b.rows() + 1 : 1;
    for (int k = -1; k <= b.planes(); ++k)
      for (int j = j0; j < j1; ++j)
        for (int i = -1; i <= b.width(); ++i) {
          const long p = b.row(j, k) + i;
          if (!mine(j, k)) continue;
          for (int d = 0; d < D; ++d) fields[d][p] = scale * place(i, j, k) + d;
          owner[p] = static_cast<std::uint8_t>(i + 2);
        }
  }
  /// Whether every value, ghosts included, is as fill() makes them on the whole grid.
  bool is_filled(double scale) const {
    const auto& b = grid.block();
    const int j0 = D == 3 ? -1 : 0, j1 = D == 3 ? b.rows() + 1 : 1;
    bool good = true;
    for (int k = -1; k <= b.planes(); ++k)
      for (int j = j0; j < j1; ++j)
        for (int i = -1; i <= b.width(); ++i) {
          const long p = b.row(j, k) + i;
          for (int d = 0; d < D; ++d) good = good && fields[d][p] == scale * place(i, j, k) + d;
          good = good && owner[p] == i + 2;
        }
    return good;
  }
  void state(Archive& archive) {
    archive.grids("field", fields, grid.part());
    archive.grid("owner", owner, grid.part());
    archive.value("number", number);
    archive.value("truth", truth);
    archive.value("mood", mood);
    archive.value("text", text);
    archive.value("point", point);
    archive.value("points", points);
    archive.value("counts", counts);
  }

  const Grid<D>& grid;
  std::array<Field, D> fields;
  Storage<std::uint8_t> owner;
  double number = 0;
  bool truth = false;
  Mood mood = Mood::calm;
  std::string text;
  Vec<D> point = Vec<D>::Zero();
  std::vector<Vec<D>> points;
  std::vector<int> counts;

 private:
  double place(int i, int j, int k) const {
    const Index<D> c = grid.block().row_cell(j, k);
    double sum = i;
    for (int d = 1; d < D; ++d) sum = 100 * sum + c[d];
    return sum;
  }
  bool mine(int j, int k) const {
    const auto& b = grid.block();
    const auto inside = [&](int c, int d) {
      const bool lower = b.offset[d] == 0, upper = b.offset[d] + b.count[d] == grid.mesh().cells[d];
      return c >= (lower ? -1 : 0) && c < b.count[d] + (upper ? 1 : 0);
    };
    return inside(k, D - 1) && (D == 2 || inside(j, 1));
  }
};

template <int D>
Mesh<D> mesh(int n = 8) {
  Mesh<D> m;
  m.lower.setZero();
  m.h.setOnes();
  m.cells.fill(n);
  return m;
}

template <int D>
Index<D> even() {
  Index<D> unit;
  unit.fill(2);
  return unit;
}

template <int D>
void set(Thing<D>& thing) {
  thing.fill(3);
  thing.number = 0.1;
  thing.truth = true;
  thing.mood = Mood::wild;
  thing.text = "[case]";
  thing.point = Vec<D>::Constant(1.0 / 3);
  thing.points.assign(5, Vec<D>::Constant(2.0 / 3));
  thing.counts = {1, 2, 3};
}

template <int D>
void expect_set(const Thing<D>& thing) {
  EXPECT_TRUE(thing.is_filled(3));
  EXPECT_EQ(thing.number, 0.1);
  EXPECT_TRUE(thing.truth);
  EXPECT_EQ(thing.mood, Mood::wild);
  EXPECT_EQ(thing.text, "[case]");
  EXPECT_EQ(thing.point, (Vec<D>(Vec<D>::Constant(1.0 / 3))));
  ASSERT_THAT(thing.points, SizeIs(5));
  EXPECT_EQ(thing.points[4], (Vec<D>(Vec<D>::Constant(2.0 / 3))));
  EXPECT_EQ(thing.counts, (std::vector<int>{1, 2, 3}));
}

/// Checkpoints of a small thing in a folder of their own, the same for all ranks.
struct Saved {
  Parallel parallel;
  Scratch dir;
  Checkpoints ring;

  explicit Saved(int keep = 2) : dir(Scratch::For::all_ranks), ring(dir.path(), keep) {}
  template <class Part>
  void write(Part& thing, long step) {
    ring.write({"washtub test", "[case]", 0.5, step}, parallel,
               [&](Archive& a) { a.value("thing", thing); });
    MPI_Barrier(parallel.comm());
  }
};

template <int D>
void comes_back() {
  Saved saved;
  const Grid<D> grid(mesh<D>(), saved.parallel, even<D>());
  Thing<D> before(grid), after(grid);
  set(before);
  saved.write(before, 7);
  StateReader(saved.ring.list().at(0)).value("thing", after);
  expect_set(after);
}

TEST(Checkpoint, StateComesBackWithAllGhosts) {
  comes_back<2>();
  comes_back<3>();
}

TEST(Checkpoint, AnotherNumberOfRanksReadsIt) {
  Saved saved;
  const Grid<3> grid(mesh<3>(), saved.parallel, even<3>());
  Thing<3> before(grid);
  set(before);
  saved.write(before, 7);
  const Grid<3> alone(mesh<3>(), Parallel(MPI_COMM_SELF), even<3>());
  Thing<3> after(alone);
  StateReader(saved.ring.list().at(0)).value("thing", after);
  expect_set(after);
}

TEST(Checkpoint, TellsOfItsRun) {
  Saved saved;
  const Grid<2> grid(mesh<2>(), saved.parallel, even<2>());
  Thing<2> thing(grid);
  saved.write(thing, 12);
  const CheckpointLabel label = read_label(saved.ring.list().at(0));
  EXPECT_EQ(label.program, "washtub test");
  EXPECT_EQ(label.case_text, "[case]");
  EXPECT_EQ(label.time, 0.5);
  EXPECT_EQ(label.step, 12);
}

TEST(Checkpoint, TheOldestGo) {
  Saved saved(2);
  const Grid<2> grid(mesh<2>(), saved.parallel, even<2>());
  Thing<2> thing(grid);
  for (const long step : {5, 20, 100}) saved.write(thing, step);
  const auto left = saved.ring.list();
  ASSERT_THAT(left, SizeIs(2));
  EXPECT_THAT(left[0], HasSubstr("checkpoint_0000000100.h5"));
  EXPECT_THAT(left[1], HasSubstr("checkpoint_0000000020.h5"));
}

TEST(Checkpoint, AnotherGridIsRefused) {
  Saved saved;
  const Grid<2> grid(mesh<2>(), saved.parallel, even<2>());
  Thing<2> thing(grid);
  saved.write(thing, 1);
  const Grid<2> finer(mesh<2>(16), saved.parallel, even<2>());
  Thing<2> other(finer);
  EXPECT_THAT([&] { StateReader(saved.ring.list().at(0)).value("thing", other); },
              ThrowsMessage<InputError>(
                  HasSubstr("the grid of thing/field x is 1 x 10 x 10, that of the case 1 x 18 x "
                            "18 (with a layer beyond each side)")));
}

/// Damages of one file, on rank 0; the other ranks see the same file.
void damage(const Saved& saved, const std::function<void(const std::string&)>& how) {
  if (saved.parallel.root()) how(saved.ring.list().at(0));
  MPI_Barrier(saved.parallel.comm());
}

void flip(const std::string& path, long at) {
  std::fstream file(path, std::ios::in | std::ios::out | std::ios::binary);
  file.seekg(at);
  const char byte = static_cast<char>(file.get() ^ 4);
  file.seekp(at);
  file.put(byte);
}

struct Damage {
  const char* name;
  std::function<void(const std::string&)> how;
  const char* message;
};

class CheckpointDamage : public ::testing::TestWithParam<Damage> {};

TEST_P(CheckpointDamage, IsSeenAndTheOneBeforeTaken) {
  Saved saved;
  const Grid<2> grid(mesh<2>(), saved.parallel, even<2>());
  Thing<2> thing(grid);
  saved.write(thing, 1);
  saved.write(thing, 2);
  damage(saved, GetParam().how);
  EXPECT_THAT([&] { check_checkpoint(saved.ring.list().at(0)); },
              ThrowsMessage<InputError>(HasSubstr(GetParam().message)));
  std::vector<std::string> damaged;
  EXPECT_THAT(saved.ring.newest(damaged), HasSubstr("checkpoint_0000000001.h5"));
  EXPECT_THAT(damaged, SizeIs(1));
}

INSTANTIATE_TEST_SUITE_P(
    Kinds, CheckpointDamage,
    ::testing::Values(
        Damage{"data", [](const std::string& p) { flip(p, 3000); }, "is damaged: its checksum is"},
        Damage{"end",
               [](const std::string& p) { flip(p, static_cast<long>(fs::file_size(p)) - 1); },
               "is damaged: its checksum is"},
        Damage{"seal", [](const std::string& p) { flip(p, 3); }, "is no checkpoint of washtub"},
        Damage{"version", [](const std::string& p) { flip(p, 19); },
               "is of version 3, this program reads version 7"},
        Damage{"cut", [](const std::string& p) { fs::resize_file(p, 2000); }, "is cut short: 2000"},
        Damage{"empty", [](const std::string& p) { fs::resize_file(p, 0); }, "is cut short"}),
    [](const auto& info) { return info.param.name; });

TEST(Checkpoint, NoneIsSaidWithWhatIsWrong) {
  Saved saved;
  std::vector<std::string> damaged;
  EXPECT_THAT(
      [&] { saved.ring.newest(damaged); },
      ThrowsMessage<InputError>(HasSubstr("checkpoints: holds no checkpoint to go on from")));
}

TEST(StateReader, AListThatTheFileCannotHoldIsRefused) {
  const Scratch folder;
  const std::string path = folder / "state.h5";
  {
    const Hdf5Handle file(H5Fcreate(path.c_str(), H5F_ACC_TRUNC, H5P_DEFAULT, H5P_DEFAULT),
                          H5Fclose);
    const hsize_t many = hsize_t{1} << 50;
    const Hdf5Handle space(H5Screate_simple(1, &many, nullptr), H5Sclose);
    H5Dclose(
        H5Dcreate2(file, "counts", H5T_NATIVE_INT, space, H5P_DEFAULT, H5P_DEFAULT, H5P_DEFAULT));
  }
  std::vector<int> counts;
  EXPECT_THAT([&] { StateReader(path).value("counts", counts); },
              ThrowsMessage<InputError>(HasSubstr("state.h5: counts is larger than the file")));
}

TEST(Snapshot, PutsEverythingBack) {
  const Parallel parallel;
  const Grid<3> grid(mesh<3>(), parallel, even<3>());
  Thing<3> thing(grid);
  set(thing);
  Snapshot snapshot;
  snapshot.take(thing);
  const double ghost = thing.fields[0][grid.block().row(-1, -1)];
  thing.fill(4);
  thing.text = "longer than before";
  thing.points.clear();
  thing.number = 5;
  snapshot.put_back(thing);
  EXPECT_EQ(thing.fields[0][grid.block().row(-1, -1)], ghost);
  EXPECT_EQ(thing.text, "[case]");
  EXPECT_THAT(thing.points, SizeIs(5));
  EXPECT_EQ(thing.number, 0.1);
}

}  // namespace
}  // namespace washtub
