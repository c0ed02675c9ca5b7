#include "record/run.hpp"

#include <fmt/format.h>
#include <spdlog/sinks/basic_file_sink.h>
#include <spdlog/spdlog.h>

#include <cmath>
#include <cstdio>

#include "base/cores.hpp"
#include "base/error.hpp"
#include "base/exit_code.hpp"
#include "base/snapshot.hpp"
#include "io/agree.hpp"
#include "io/checkpoint.hpp"
#include "io/file.hpp"
#include "record/build_facts.hpp"
#include "record/checkpoint_clock.hpp"
#include "record/output.hpp"
#include "record/progress.hpp"
#include "record/schedule.hpp"
#include "record/stop.hpp"
#include "record/summarise.hpp"
#include "washer/settle.hpp"
#include "washer/watch.hpp"

namespace washtub {
namespace {

constexpr int tries = 3;            // of an interval between rows, each with half the step
constexpr int watched_steps = 100;  // after which it is seen whether the ranks have their cores
constexpr double share = 0.5;       // of the step before, from try to try

/// log.txt on rank 0; silent elsewhere.
std::shared_ptr<spdlog::logger> open_log(const RunOptions& options, bool root) {
  if (!root) return std::make_shared<spdlog::logger>("run");
  try {
    auto sink = std::make_shared<spdlog::sinks::basic_file_sink_mt>(options.directory + "/log.txt",
                                                                    options.resumed.empty());
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

std::unique_ptr<StateReader> open_state(const std::string& path) {
  return path.empty() ? nullptr : std::make_unique<StateReader>(path, "run/simulation/");
}

/// A run from its start or a checkpoint to its end, to the user's wish to stop, or to a failure.
template <int D>
class Run {
 public:
  Run(const Case& whole, const RunOptions& options)
      : case_(whole),
        options_(options),
        log_(open_log(options, parallel_.root())),
        developed_(open_state(options.developed)),
        progress_(whole.time.end, parallel_.root()),
        settled_(settle_first()),
        simulation_(whole, parallel_, developed_.get(), settled_.places),
        observer_(simulation_),
        output_(simulation_, observer_, options.directory),
        schedule_(whole),
        checkpoints_(options.directory, whole.checkpoint.keep),
        clock_(whole.checkpoint) {
    if (settled_.time > 0 && !settled_.at_rest && !settled_.stopped) {
      observer_.self_watch().note_start(settled_text(settled_));
      tell(settled_text(settled_));
    }
    const auto& ranks = simulation_.grid().ranks();
    log_->info("{} ranks ({}), {} pieces of cloth, {} nodes", parallel_.size(),
               fmt::join(ranks, " x "), simulation_.cloth().pieces(), simulation_.cloth().nodes());
  }

  int run() {
    if (settled_.stopped) return exit_stopped;
    try {
      begin();
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

  /// Everything that a run which goes on has to know.
  void state(Archive& archive) {
    archive.value("simulation", simulation_);
    archive.value("observer", observer_);
    archive.value("output", output_);
    archive.value("schedule", schedule_);
    archive.value("progress", progress_);
  }

 private:
  /// What a run is told, before anything is simulated.
  void write_head() {
    log_->info("{}", fmt::join(options_.arguments, " "));
    const BuildFacts& build = build_facts();
    log_->info("commit {}, {} for {} ({}, {} bits wide), on {}", build.commit, build.compiler,
               build.target, build.instructions, build.vector_width, processor());
    for (const std::string& note : case_.notes) log_->info("note: {}", note);
    if (parallel_.root())
      for (const std::string& doubt : doubts(case_)) log_->info("warning: {}", doubt);
    if (parallel_.root()) replace_file(options_.directory + "/case.toml", case_.resolved);
  }

  /// Before a run that starts at t = 0 with its own cloth, if the case asks for it.
  Settled<D> settle_first() {
    write_head();
    if (!(case_.settle.time > 0) || case_.cloth.empty() || !options_.resumed.empty()) return {};
    if (developed_) {
      tell("the cloth starts as the other run left it: [settle] has no effect with --from");
      return {};
    }
    const Progress progress(case_.settle.time, parallel_.root());
    const Settled<D> settled = settle_with_care(progress);
    progress.finish();
    if (settled.stopped || settled.at_rest) tell(settled_text(settled));
    return settled;
  }

  /// Where that fails, again with smaller steps.
  Settled<D> settle_with_care(Progress progress) {
    const auto watch = [&](const Simulation<D>& simulation) {
      progress.show(simulation.time(), "settling  " + describe<D>(simulation.last()));
      return parallel_.max(stop_requested()) == 0;
    };
    for (int left = tries;; --left) try {
        return settle<D>(case_, parallel_, watch, std::pow(share, tries - left));
      } catch (const RunError& error) {
        if (left > 0) {
          tell(fmt::format("{}. Trying again with half of the step", error.what()));
          continue;
        }
        log_->error("{}", error.what());
        throw;
      }
  }

  static std::string settled_text(const Settled<D>& settled) {
    if (settled.stopped)
      return "stopped while the cloth settled, before t = 0; there is nothing to go on from";
    if (settled.at_rest) return fmt::format("the cloth has settled in {:.3g} s", settled.time);
    return fmt::format(
        "After {:.3g} s of settling the cloth still moved at {:.2g} m/s (rms), and the run begins "
        "with it as it lay; try a longer settle.time or a larger settle.gravity.",
        settled.time, settled.speed);
  }

  void begin() {
    if (options_.resumed.empty()) {
      output_.start();
      sample(true);
      if (!options_.developed.empty()) save();  // what it started from may be gone later
      return;
    }
    StateReader(options_.resumed).value("run", *this);
    tell(fmt::format("going on from {} at t = {:.6g} s", options_.resumed, simulation_.time()));
    for (const std::string& change : options_.changes) tell("before: " + change);
    const std::string lost = output_.go_on();
    if (!lost.empty()) tell(lost);
    clock_.start(simulation_.time());
    row_.take(*this);
  }

  /// Steps to the end. A row that is due comes before anything else, so that a run that goes on
  /// from a checkpoint knows all rows up to its time.
  int advance() {
    double due = schedule_.next(simulation_.time());
    while (!schedule_.reached(simulation_.time(), case_.time.end)) {
      step(due);
      show_progress();
      if (schedule_.reached(simulation_.time(), due)) {
        sample(schedule_.take_frame(simulation_.time()));
        tries_left_ = tries;
        due = schedule_.next(simulation_.time());
      }
      const Wish wish = this->wish();
      if (wish == Wish::stop) return stop();
      if (wish == Wish::save) save();
    }
    save();
    finish("complete");
    return 0;
  }

  void show_progress() {
    const std::string state = describe<D>(simulation_.last());
    if (progress_.show(simulation_.time(), state))
      log_->info("t {:.6g} s  {}", simulation_.time(), state);
  }

  enum class Wish { none, save, stop };

  /// What any rank was asked to do between two steps, the same on all.
  Wish wish() const {
    const bool due = parallel_.root() && clock_.due(simulation_.time());
    const Wish mine = stop_requested() ? Wish::stop : due ? Wish::save : Wish::none;
    return static_cast<Wish>(static_cast<int>(parallel_.max(static_cast<double>(mine))));
  }

  /// A run that goes on later knows nothing of the last row and frame.
  int stop() {
    const bool saved = save();
    if (observer_.sampled() < simulation_.time()) write(true);
    finish("stopped");
    return saved ? exit_stopped : exit_failed;
  }

  /// A step; where it fails, those since the last row are done again with smaller ones and more
  /// cycles of the pressure solve. Where that does not help the run ends, with a last row and frame
  /// of the state that failed, and with a checkpoint of the last row's.
  void step(double due) {
    try {
      share_.begin();
      const auto& taken = simulation_.step(due);
      share_.end();
      observer_.watch(taken);
      if (++watched_ == watched_steps) watch_cores();
    } catch (const RunError& error) {
      const bool pressure = dynamic_cast<const PressureError*>(&error) != nullptr;
      if (tries_left_ > 0 && (pressure || !case_.time.fixed))
        return try_again(error.what(), pressure);
      give_up();
      throw;
    }
  }

  /// Whether other programs hold up a rank, and so all.
  void watch_cores() {
    const double least = parallel_.min(share_.share());
    share_ = {};
    if (const auto text = crowded(least, parallel_.size()); text && !told_crowded_) {
      tell(*text);
      told_crowded_ = true;
    }
    watched_ = 0;
  }

  void try_again(const std::string& reason, bool pressure) {
    const double failed = simulation_.time();
    row_.put_back(*this);
    const double part = std::pow(share, tries - --tries_left_);
    simulation_.be_cautious(part);
    const std::string what =
        tries_left_ == tries - 1 ? reason : fmt::format("the same at t = {:.6g} s", failed);
    std::vector<std::string> remedies;
    if (pressure) remedies.push_back(fmt::format("{:g} times the cycles", 1 / (part * part)));
    if (!case_.time.fixed) remedies.push_back(fmt::format("{:g} of the step", part));
    tell(fmt::format("{}. Trying again from t = {:.6g} s with {}", what, simulation_.time(),
                     fmt::join(remedies, " and ")));
  }

  void give_up() {
    try {
      if (simulation_.finite()) write(true);
    } catch (const RunError&) {  // what went wrong first is what counts
    }
    keep_last_row();
  }

  /// A checkpoint of the state at the last row.
  void keep_last_row() {
    if (row_.empty()) return;
    row_.put_back(*this);
    save();
  }

  /// A row, and maybe a frame, of the state now.
  void write(bool frame) {
    const InPhase writing(&simulation_.clock(), Phase::output);
    output_.add_row(observer_.observe());
    if (const auto alarm = observer_.self_watch().first_alarm())
      tell(fmt::format("t = {:.4g} s: {} The run goes on.", simulation_.time(), *alarm));
    if (!frame || case_.output.frames <= 0) return;
    observer_.self_watch().look_at_cloth();
    output_.add_frame();
  }

  /// The same, and from now on the run may go back to here.
  void sample(bool frame) {
    try {
      write(frame);
    } catch (const RunError&) {
      keep_last_row();
      throw;
    }
    const InPhase keeping(&simulation_.clock(), Phase::checkpoints);
    row_.take(*this);
  }

  /// A checkpoint; where it cannot be written the run goes on. Returns whether it was.
  bool save() {
    const InPhase saving(&simulation_.clock(), Phase::checkpoints);
    const CheckpointLabel label{options_.program,          case_.resolved,
                                simulation_.time(),        simulation_.last().number,
                                case_.output.window_begin, case_.output.window_end};
    bool saved = true;
    try {
      agree(parallel_, output_.sync());
      checkpoints_.write(label, parallel_, [&](Archive& a) { a.value("run", *this); });
    } catch (const RunError& error) {
      tell(fmt::format("no checkpoint: {}", error.what()));
      saved = false;
    }
    clock_.start(simulation_.time());
    return saved;
  }

  /// Tells the user and the log.
  void tell(const std::string& text) {
    log_->warn("{}", text);
    if (parallel_.root()) std::fputs(fmt::format("washtub: {}\n", text).c_str(), stderr);
  }

  void finish(const std::string& outcome) {
    progress_.finish();
    simulation_.clock().enter(Phase::rest);
    output_.write_summary(outcome, progress_.elapsed());
    const std::string line =
        fmt::format("{}: t {:.6g} s, {} steps, {:.1f} s of computing",
                    outcome == "complete" || outcome == "stopped" ? outcome : "failed",
                    simulation_.time(), simulation_.last().number, progress_.elapsed());
    for (const auto& warning : observer_.quality().warnings(case_)) tell(warning);
    log_->info("time of the first rank: {}", phases_text(simulation_.clock().spent()));
    log_->info(line);
    if (parallel_.root())
      std::fputs(fmt::format("{}; results in {}\n", line, options_.directory).c_str(), stderr);
  }

  const Case& case_;
  const RunOptions& options_;
  Parallel parallel_;
  std::shared_ptr<spdlog::logger> log_;
  std::unique_ptr<StateReader> developed_;
  Progress progress_;
  Settled<D> settled_;  ///< without places where the cloth has not settled
  Simulation<D> simulation_;
  Observer<D> observer_;
  Output<D> output_;
  Schedule schedule_;
  Checkpoints checkpoints_;
  CheckpointClock clock_;
  Snapshot row_;  ///< the state at the last row
  int tries_left_ = tries;
  CoreShare share_;
  int watched_ = 0;  ///< steps in it
  bool told_crowded_ = false;
};

}  // namespace

int run_case(const Case& whole, const RunOptions& options) {
  if (whole.dimension == 2) return Run<2>(whole, options).run();
  return Run<3>(whole, options).run();
}

}  // namespace washtub
