#pragma once
#include <memory>
#include <string>

#include "io/frame.hpp"
#include "io/history.hpp"
#include "record/columns.hpp"
#include "record/observer.hpp"

namespace washtub {

/// The output directory of a run: history.csv, tracks.csv, frames and summary.json, each from what
/// the observer saw.
template <int D>
class Output {
 public:
  Output(const Simulation<D>& simulation, const Observer<D>& observer,
         const std::string& directory);

  /// Files of a new run.
  void start();
  /// Goes on behind the rows and frames that were written when the state was saved; returns a
  /// sentence where some of them are lost.
  std::string go_on();
  /// Waits until all rows are on the disk; the reason where they are not, "" where they are.
  std::string sync() const;
  /// Rows and frames so far.
  void state(Archive& archive);

  /// A row of history.csv and of tracks.csv (collective).
  /// @throws RunError with path and reason, on all ranks
  void add_row(const Sample& sample);
  /// Collective. @throws RunError where the water is not finite, or the frame cannot be written
  void add_frame();
  /// `outcome`: "complete", "stopped" or the reason of a failure.
  void write_summary(const std::string& outcome, double wall_time) const;

 private:
  FluidBlock water();
  void check_finite(const FluidBlock& fluid) const;
  std::vector<ClothPiece> cloth() const;

  const Simulation<D>& simulation_;
  const Observer<D>& observer_;
  std::string directory_;
  std::vector<RecordColumn> history_columns_, track_columns_;
  std::unique_ptr<History> history_, tracks_;        ///< on rank 0
  int rows_ = 0, track_rows_ = 0, frame_count_ = 0;  ///< that belong to the state of the run
  FrameWriter frames_;
  std::vector<std::vector<float>> water_;  ///< this rank's cells, of each of water_fields()
};

}  // namespace washtub
