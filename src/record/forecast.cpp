#include "record/forecast.hpp"

#include <fmt/format.h>
#include <stdlib.h>
#include <sys/resource.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <filesystem>
#include <numeric>

#include "base/error.hpp"
#include "base/snapshot.hpp"
#include "io/agree.hpp"
#include "io/checkpoint.hpp"
#include "record/output.hpp"

namespace washtub {
namespace {

constexpr double most_cells = 1e6;  // of the grid on which steps are tried
constexpr double patience = 2;      // for them [s]
constexpr int first_steps = 3;      // which do more than later ones
constexpr int least_steps = 5, most_steps = 400;
/// Largest speed of the water over that of what drives it, as it is in washes.
constexpr double overshoot = 1.2;
constexpr int parts = 8;  // of an interval between rows, in which speeds are looked at

double seconds_since(std::chrono::steady_clock::time_point start) {
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
}

double cell_count(const Case& whole) {
  double cells = 1;
  for (int axis = 0; axis < whole.dimension; ++axis)
    cells *= whole.domain.cells[static_cast<std::size_t>(axis)];
  return cells;
}

double size_of(const std::string& path) {
  double bytes = 0;
  if (std::filesystem::is_regular_file(path))
    return static_cast<double>(std::filesystem::file_size(path));
  for (const auto& entry : std::filesystem::recursive_directory_iterator(path))
    if (entry.is_regular_file()) bytes += static_cast<double>(entry.file_size());
  return bytes;
}

/// Largest memory of this process so far [B].
double memory_used() {
  rusage usage{};
  getrusage(RUSAGE_SELF, &usage);
  return 1024.0 * static_cast<double>(usage.ru_maxrss);
}

/// The same case on cells `times` as wide, with the cloth's nodes as they are.
Case coarsen(const Case& whole, int times) {
  Case coarse = whole;
  for (ClothCase& cloth : coarse.cloth) cloth.nodes = cloth_nodes(cloth, whole);
  for (int axis = 0; axis < whole.dimension; ++axis) {
    int& n = coarse.domain.cells[static_cast<std::size_t>(axis)];
    n = std::max(8, n / times);
  }
  return coarse;
}

/// A directory that all ranks write to, removed at the end.
class TrialDirectory {
 public:
  explicit TrialDirectory(const Parallel& parallel) : parallel_(parallel) {
    if (parallel.root()) {
      path_ = (std::filesystem::temp_directory_path() / "washtub-XXXXXX").string();
      if (!mkdtemp(path_.data())) path_.clear();
    }
    path_ = from_root(parallel, path_);
    if (path_.empty()) throw RunError("cannot make a directory for trial files");
  }
  ~TrialDirectory() {
    MPI_Barrier(parallel_.comm());
    std::error_code ignored;
    if (parallel_.root()) std::filesystem::remove_all(path_, ignored);
  }
  TrialDirectory(const TrialDirectory&) = delete;
  TrialDirectory& operator=(const TrialDirectory&) = delete;
  const std::string& path() const { return path_; }

 private:
  const Parallel& parallel_;
  std::string path_;
};

/// What was measured of a run that was begun: per step, row, frame and checkpoint.
struct Trial {
  double step = 0, cloth_step = 0;  ///< the part of water and solids, and that of cloth [s]
  double driving_speed = 0, start_rate = 0;
  double row = 0, frame = 0, checkpoint = 0;                    ///< [s]
  double row_bytes = 0, frame_bytes = 0, checkpoint_bytes = 0;  ///< on the disk
  double memory = 0;                                            ///< of all ranks [B]
  std::string failure;
};

template <int D>
class Beginning {
 public:
  Beginning(const Case& whole, const Parallel& parallel)
      : case_(whole),
        parallel_(parallel),
        directory_(parallel),
        simulation_(whole, parallel),
        observer_(simulation_),
        output_(simulation_, observer_, directory_.path()) {}

  Trial measure() {
    try {
      steps();
    } catch (const RunError& error) {
      trial_.failure = error.what();
      return trial_;
    }
    output_.start();
    rows();
    snapshot_.take(simulation_);
    frames();
    checkpoints();
    trial_.memory = parallel_.sum(memory_used());
    return trial_;
  }

 private:
  /// Wall time of something, the largest of the ranks.
  template <class Do>
  double time(Do&& act) const {
    const auto start = std::chrono::steady_clock::now();
    act();
    return parallel_.max(seconds_since(start));
  }

  void steps() {
    const auto step = [&] { simulation_.step(simulation_.time() + case_.output.every); };
    for (int i = 0; i < first_steps; ++i) step();
    const auto before = simulation_.clock().spent();
    int n = 0;
    for (double spent = 0; n < least_steps || (spent < patience && n < most_steps); ++n)
      spent += time(step);
    const auto& after = simulation_.clock().spent();
    for (std::size_t p = 0; p < phases; ++p) {
      const Phase phase = static_cast<Phase>(p);
      const bool cloth =
          phase == Phase::cloth || phase == Phase::contact || phase == Phase::exchange;
      (cloth ? trial_.cloth_step : trial_.step) += (after[p] - before[p]) / n;
    }
    const auto& last = simulation_.last();
    trial_.start_rate = last.courant / last.dt;
    trial_.driving_speed = simulation_.driving_speed();
  }

  void rows() {
    Sample sample = observer_.observe();
    trial_.row = time([&] {
      sample = observer_.observe();
      output_.add_row(sample);
    });
    const double before = tables();
    output_.add_row(sample);
    trial_.row_bytes = tables() - before;
  }

  /// Bytes of history and tracks, on rank 0.
  double tables() const {
    double bytes = 0;
    for (const char* name : {"/history.csv", "/tracks.csv"}) {
      const std::string path = directory_.path() + name;
      if (parallel_.root() && std::filesystem::exists(path)) bytes += size_of(path);
    }
    return bytes;
  }

  void frames() {
    if (case_.output.frames <= 0) return;
    trial_.frame = time([&] {
      observer_.self_watch().look_at_cloth();
      output_.add_frame();
    });
    if (parallel_.root()) trial_.frame_bytes = size_of(directory_.path() + "/frames");
  }

  void checkpoints() {
    trial_.checkpoint = time([&] {
      Checkpoints(directory_.path(), 1).write({}, parallel_, [&](Archive& a) {
        a.value("run", simulation_);
      });
    });
    if (parallel_.root()) trial_.checkpoint_bytes = size_of(directory_.path() + "/checkpoints");
  }

  const Case& case_;
  const Parallel& parallel_;
  TrialDirectory directory_;
  Simulation<D> simulation_;
  Observer<D> observer_;
  Output<D> output_;
  Snapshot snapshot_;
  Trial trial_;
};

Trial begin(const Case& whole, const Parallel& parallel) {
  return whole.dimension == 2 ? Beginning<2>(whole, parallel).measure()
                              : Beginning<3>(whole, parallel).measure();
}

/// Bound of the sum over the axes of |u| / h at a time [1/s].
double rate(const Case& whole, double driving_speed, double start_rate, double t) {
  double turning = 0;
  bool moves = false;
  for (const SolidCase& solid : whole.solids) {
    if (!solid.drive.moving()) continue;
    moves = true;
    turning = std::max(turning, std::abs(solid.drive.speed(t)) / solid.drive.peak());
  }
  if (!moves) return start_rate;
  const DomainCase& box = whole.domain;
  const double across =
      std::hypot(box.cells[0] / box.size[0], box.cells[1] / box.size[1]);  // [1/m]
  return overshoot * turning * driving_speed * across;
}

}  // namespace

double foresee_steps(const Case& whole, double driving_speed, double start_rate) {
  const TimeCase& time = whole.time;
  if (time.fixed) return std::ceil(time.end / time.step - 1e-9);
  const double every = whole.output.every;
  double steps = 0;
  for (double t = 0; t < time.end * (1 - 1e-9); t += every) {
    const double interval = std::min(every, time.end - t);
    double needed = 0;
    for (int part = 0; part < parts; ++part) {
      const double r = rate(whole, driving_speed, start_rate, t + (part + 0.5) / parts * interval);
      needed += interval / parts * std::max(time.step > 0 ? 1 / time.step : 0.0, r / time.cfl);
    }
    steps += std::max(1.0, std::ceil(needed - 1e-3));
  }
  return steps;
}

Forecast foresee(const Case& whole, const Parallel& parallel) {
  Forecast forecast;
  const double program = parallel.sum(memory_used());
  while (cell_count(whole) / std::pow(forecast.coarser, whole.dimension) > most_cells)
    forecast.coarser *= 2;
  const Case tried = forecast.coarser > 1 ? coarsen(whole, forecast.coarser) : whole;
  const Trial trial = begin(tried, parallel);
  forecast.failure = trial.failure;
  if (!trial.failure.empty()) return forecast;

  const double larger = cell_count(whole) / cell_count(tried);
  forecast.steps = foresee_steps(whole, trial.driving_speed, trial.start_rate * forecast.coarser);
  const double rows = std::ceil(whole.time.end / whole.output.every) + 1;
  const double frames =
      whole.output.frames > 0 ? std::floor(whole.time.end / whole.output.frames + 1e-9) + 1 : 0;
  forecast.seconds = forecast.steps * (trial.step * larger + trial.cloth_step) +
                     rows * trial.row * larger + frames * trial.frame * larger;
  const CheckpointCase& clock = whole.checkpoint;
  const double saved = 1 + (clock.every > 0 ? std::floor(whole.time.end / clock.every) : 0) +
                       (clock.wall_time > 0 ? std::floor(forecast.seconds / clock.wall_time) : 0);
  forecast.seconds += saved * trial.checkpoint * larger;
  forecast.checkpoints = std::min<double>(saved, clock.keep) * trial.checkpoint_bytes * larger;
  forecast.frames = frames * trial.frame_bytes * larger;
  forecast.tables = rows * trial.row_bytes;
  forecast.memory = program + (trial.memory - program) * larger;
  return forecast;
}

}  // namespace washtub
