#pragma once
#include <memory>
#include <string>

#include "io/frame.hpp"
#include "io/history.hpp"
#include "record/observer.hpp"

namespace washtub {

/// The output directory of a run: history.csv, tracks.csv, frames and summary.json, each from what
/// the observer saw.
template <int D>
class Output {
 public:
  Output(const Simulation<D>& simulation, const Observer<D>& observer,
         const std::string& directory);

  void add_row(const Sample& sample);  ///< to history.csv and tracks.csv
  void add_frame();                    ///< collective
  /// `outcome`: "complete", "stopped" or the reason of a failure.
  void write_summary(const std::string& outcome, double wall_time) const;

 private:
  std::vector<Column> history_columns() const;
  std::vector<Column> track_columns() const;

  const Simulation<D>& simulation_;
  const Observer<D>& observer_;
  std::string directory_;
  std::unique_ptr<History> history_, tracks_;  ///< on rank 0
  FrameWriter frames_;
  std::vector<float> velocity_, pressure_, solid_;
};

}  // namespace washtub
