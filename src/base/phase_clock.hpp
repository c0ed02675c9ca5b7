#pragma once
#include <array>
#include <chrono>
#include <cstddef>

namespace washtub {

/// What a run spends its time on.
enum class Phase {
  solids,       ///< their motion and which faces they close
  prediction,   ///< momentum without pressure
  cloth,        ///< its forces and its implicit solve
  contact,      ///< of cloth with cloth
  exchange,     ///< spreading, interpolation and mobility
  projection,   ///< pressure
  loads,        ///< what the water does to solids
  output,       ///< rows, frames and statistics
  checkpoints,  ///< and the states in memory to go back to
  rest,
};
inline constexpr std::size_t phases = static_cast<std::size_t>(Phase::rest) + 1;

/// Where the time of one rank goes: at any time it is in one phase. Waiting for other ranks counts
/// for the phase in which it happens.
class PhaseClock {
 public:
  /// What follows is of this phase. Returns the one until now.
  Phase enter(Phase next) {
    const Time now = std::chrono::steady_clock::now();
    spent_[static_cast<std::size_t>(now_in_)] +=
        std::chrono::duration<double>(now - since_).count();
    since_ = now;
    const Phase before = now_in_;
    now_in_ = next;
    return before;
  }
  /// Seconds in each phase until the last enter().
  const std::array<double, phases>& spent() const { return spent_; }

 private:
  using Time = std::chrono::steady_clock::time_point;

  std::array<double, phases> spent_{};
  Time since_ = std::chrono::steady_clock::now();
  Phase now_in_ = Phase::rest;
};

/// A phase within another one, which goes on at the end of the scope. Nothing without a clock.
class InPhase {
 public:
  InPhase(PhaseClock* clock, Phase phase)
      : clock_(clock), before_(clock ? clock->enter(phase) : phase) {}
  ~InPhase() {
    if (clock_) clock_->enter(before_);
  }
  InPhase(const InPhase&) = delete;
  InPhase& operator=(const InPhase&) = delete;

 private:
  PhaseClock* clock_;
  Phase before_;
};

}  // namespace washtub
