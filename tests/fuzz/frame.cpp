#include "input.hpp"
#include "io/file.hpp"
#include "io/frame_reader.hpp"
#include "io/scratch.hpp"
#include "scratch_file.hpp"
#include "session.hpp"

using namespace washtub;

namespace {

/// Of 2 x 3 x 2 cells, a solid that turns, a cylinder of cloth with 3 x 2 nodes and a flat piece.
std::string sound_frame() {
  const Scratch folder;
  FrameWriter writer(folder.path(), Parallel(MPI_COMM_SELF), 3, {{2, 3, 2}, {0, 0, 0}, {1, 1, 1}});
  const std::vector<float> u(36, 0.5f), p(12, 2.0f);
  const std::vector<double> x(18, 0.25), s(6, 1.0);
  const std::span<const double> places(x), stress(s);
  Frame frame{1.5,
              {{0, 0, 0},
               {2, 3, 2},
               {{{"velocity", "velocity", "m/s", 3, "of the water"}, u},
                {{"pressure", "pressure", "Pa", 1, ""}, p}}},
              {{"total", "total stress", "Pa", 1, ""}},
              {{{3, 2}, places, {stress}, {true, false}},
               {{2, 2}, places.first(12), {stress.first(4)}, {}}},
              {{"agitator", 0.5}}};
  writer.write(frame);
  return read_file(frame_path(folder.path(), 0));
}

}  // namespace

extern "C" int LLVMFuzzerInitialize(int* argc, char*** argv) {
  fuzz::start_session(argc, argv);
  return 0;
}

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  static const std::string sound = sound_frame();
  static const fuzz::ScratchFile file;
  file.write(fuzz::damaged(sound, fuzz::text_of(data, size)));
  if (size == 0) FrameReader(file.path()).water();
  fuzz::takes([] {
    const FrameReader frame(file.path());
    fuzz::takes([&] { frame.time(); });
    fuzz::takes([&] { frame.solids(); });
    fuzz::takes([&] { frame.cloth(); });
    fuzz::takes([&] { frame.cells(); });
    fuzz::takes([&] { frame.water(); });
  });
  return 0;
}
