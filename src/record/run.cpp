#include "record/run.hpp"

#include <fmt/format.h>
#include <spdlog/sinks/basic_file_sink.h>
#include <spdlog/spdlog.h>

#include <cmath>

#include "base/error.hpp"
#include "io/file.hpp"
#include "record/output.hpp"
#include "record/progress.hpp"
#include "record/stop.hpp"

namespace washtub {
namespace {

constexpr int stopped = 130;

/// log.txt on rank 0; silent elsewhere.
std::shared_ptr<spdlog::logger> open_log(const std::string& directory, bool root) {
  if (!root) return std::make_shared<spdlog::logger>("run");
  try {
    auto sink = std::make_shared<spdlog::sinks::basic_file_sink_mt>(directory + "/log.txt", true);
    auto log = std::make_shared<spdlog::logger>("run", sink);
    log->flush_on(spdlog::level::info);
    return log;
  } catch (const spdlog::spdlog_ex& e) {
    throw RunError(e.what());
  }
}

template <int D>
std::string describe(const typename Simulation<D>::Step& s) {
  return fmt::format("step {}  dt {:.2e} s ({})  CFL {:.2f}  div {:.0e}", s.number, s.dt,
                     name(s.limit), s.courant, s.divergence);
}

/// A run from its start to its end, to the user's wish to stop, or to a failure.
template <int D>
class Run {
 public:
  Run(const Case& whole, const RunOptions& options)
      : case_(whole),
        log_(open_log(options.directory, parallel_.root())),
        simulation_(whole, parallel_),
        observer_(simulation_),
        directory_(options.directory),
        output_(simulation_, observer_, options.directory),
        progress_(whole.time.end, parallel_.root()) {
    if (parallel_.root()) replace_file(options.directory + "/case.toml", whole.resolved);
    log_->info("washtub {}", fmt::join(options.arguments, " "));
    const auto& ranks = simulation_.grid().ranks();
    log_->info("{} ranks ({}), {} pieces of cloth, {} nodes", parallel_.size(),
               fmt::join(ranks, " x "), simulation_.cloth().pieces(), simulation_.cloth().nodes());
  }

  int run() {
    try {
      return advance();
    } catch (const RunError& error) {
      log_->error("{}", error.what());
      try {
        finish(error.what());
      } catch (const RunError&) {  // what went wrong first is what counts
      }
      throw;
    }
  }

 private:
  int advance() {
    sample(true);
    const double end = case_.time.end, every = case_.output.every;
    const auto samples = static_cast<long>(std::ceil(end / every - 1e-9));
    for (long s = 1; s <= samples; ++s) {
      const double latest = std::min(end, static_cast<double>(s) * every);
      const double close = case_.time.fixed ? 0.5 * case_.time.step : 1e-9 * every;
      while (simulation_.time() < latest - close) {
        step(latest);
        if (progress_.show(simulation_.time(), describe<D>(simulation_.last())))
          log_->info("t {:.6g} s  {}", simulation_.time(), describe<D>(simulation_.last()));
        if (parallel_.any(stop_requested())) return stop();
      }
      sample(frame_due());
    }
    finish("complete");
    return 0;
  }

  /// A step; where it fails, the state is written before the run ends.
  void step(double latest) {
    try {
      observer_.watch(simulation_.step(latest));
    } catch (const RunError&) {
      try {
        sample(true);
      } catch (const RunError&) {  // what went wrong first is what counts
      }
      throw;
    }
  }

  bool frame_due() {
    if (case_.output.frames <= 0) return false;
    const auto due = static_cast<long>(simulation_.time() / case_.output.frames + 1e-6);
    const bool is_due = due > frames_;
    frames_ = std::max(frames_, due);
    return is_due;
  }

  void sample(bool frame) {
    output_.add_row(observer_.observe());
    if (frame && case_.output.frames > 0) output_.add_frame();
  }

  int stop() {
    sample(true);
    finish("stopped");
    return stopped;
  }

  void finish(const std::string& outcome) {
    progress_.finish();
    output_.write_summary(outcome, progress_.elapsed());
    const std::string line =
        fmt::format("{}: t {:.6g} s, {} steps, {:.1f} s of computing", outcome, simulation_.time(),
                    simulation_.last().number, progress_.elapsed());
    log_->info(line);
    if (parallel_.root()) fmt::print(stderr, "{}; results in {}\n", line, directory_);
  }

  const Case& case_;
  Parallel parallel_;
  std::shared_ptr<spdlog::logger> log_;
  Simulation<D> simulation_;
  Observer<D> observer_;
  std::string directory_;
  Output<D> output_;
  Progress progress_;
  long frames_ = 0;
};

}  // namespace

int run_case(const Case& whole, const RunOptions& options) {
  if (whole.dimension == 2) return Run<2>(whole, options).run();
  return Run<3>(whole, options).run();
}

}  // namespace washtub
