#pragma once
#include <chrono>
#include <optional>
#include <string>

namespace washtub {

/// A rank for each core that no other program keeps busy, at least one: ranks wait for each other,
/// so that one which has to share its core slows down all. `busy`: how many cores others use.
int free_ranks(int cores, double busy);

/// Processors among those of this process that are in use now, from how much they rested over a
/// fifth of a second; 0 where the system does not tell.
double busy_cores();

/// How much of a core this process gets while it has work to do or waits for other ranks in a loop.
class CoreShare {
 public:
  void begin();  ///< of a piece of work
  void end();
  /// Time of the processor over time passed, in all pieces; 1 where there was none.
  double share() const { return passed_ > 0 ? worked_ / passed_ : 1; }

 private:
  std::chrono::steady_clock::time_point since_;
  double worked_since_ = 0, worked_ = 0, passed_ = 0;  ///< [s]
};

/// What to tell the user where a rank shares its core with another program. `share`: the least of
/// all ranks.
std::optional<std::string> crowded(double share, int ranks);

}  // namespace washtub
