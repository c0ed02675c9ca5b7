#include "io/checkpoint.hpp"

#include "input.hpp"
#include "io/file.hpp"
#include "io/scratch.hpp"
#include "io/seal.hpp"
#include "scratch_file.hpp"
#include "session.hpp"

using namespace washtub;

namespace {

enum class Mood { calm, wild };

/// Something with a state of every kind that an archive knows.
struct Thing {
  double number = 1.5;
  long count = 7;
  bool truth = true;
  Mood mood = Mood::wild;
  std::string text = "washer";
  Vec<3> point = Vec<3>::Ones();
  std::vector<Vec<3>> points = {Vec<3>::Zero(), Vec<3>::Ones()};
  std::vector<int> counts = {1, 2, 3}, three = {4, 5, 6};
  std::vector<float> cells = std::vector<float>(24, 1.0f);

  void state(Archive& archive) {
    const GridPart part{{2, 3, 4}, {}, {2, 3, 4}, {}, {2, 3, 4}, {2, 3, 4}};
    archive.value("number", number);
    archive.value("count", count);
    archive.value("truth", truth);
    archive.value("mood", mood);
    archive.value("text", text);
    archive.value("point", point);
    archive.value("points", points);
    archive.value("counts", counts);
    archive.same_length("three", three);
    archive.grid("cells", cells, part);
  }
};

std::string sound_checkpoint() {
  const Scratch folder;
  const Checkpoints checkpoints(folder.path(), 1);
  Thing thing;
  checkpoints.write({"washtub", "dimension = 3", 1.5, 12}, Parallel(MPI_COMM_SELF),
                    [&](Archive& archive) { archive.value("run", thing); });
  return read_file(checkpoints.list().front());
}

void read(const std::string& path) {
  read_label(path);
  Thing thing;
  StateReader(path).value("run", thing);
}

}  // namespace

extern "C" int LLVMFuzzerInitialize(int* argc, char*** argv) {
  fuzz::start_session(argc, argv);
  return 0;
}

/// The first byte of the input says whether the damaged file is sealed again.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  static const std::string sound = sound_checkpoint();
  static const fuzz::ScratchFile file;
  if (size == 0) return 0;
  file.write(fuzz::damaged(sound, fuzz::text_of(data + 1, size - 1)));
  if (data[0] % 2 == 1) seal_file(file.path(), "checkpoint", checkpoint_version);
  if (size == 1)
    read(file.path());  // sound
  else
    fuzz::takes([] { read(file.path()); });
  return 0;
}
