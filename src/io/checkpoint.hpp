#pragma once
#include <functional>
#include <string>
#include <vector>

#include "base/parallel.hpp"
#include "io/state_file.hpp"

namespace washtub {

/// Of the names and meanings of what a checkpoint holds.
inline constexpr int checkpoint_version = 7;

/// What a checkpoint tells of the run that wrote it.
struct CheckpointLabel {
  std::string program;    ///< name and version
  std::string case_text;  ///< the case as resolved
  double time = 0;        ///< [s]
  long step = 0;
  double window_begin = 0, window_end = 0;  ///< of the statistics in progress [s]

  void state(Archive& archive);
};

/// The checkpoints of a run, DIR/checkpoints/checkpoint_<step>.h5: HDF5 files behind a seal. Each
/// is written under a temporary name, sealed, synced and renamed; then those of later steps, which
/// the run has left, are removed, and the oldest until `keep` are left.
class Checkpoints {
 public:
  Checkpoints(const std::string& directory, int keep)
      : folder_(directory + "/checkpoints"), keep_(keep) {}

  /// Collective. `save` names the state. On return the checkpoint is on the disk.
  /// @throws RunError on all ranks, with path and reason; older checkpoints are then untouched
  void write(CheckpointLabel label, const Parallel& parallel,
             const std::function<void(Archive&)>& save) const;

  /// Paths, newest first.
  std::vector<std::string> list() const;

  /// The newest checkpoint that is whole; `damaged` gets a sentence for each newer one that is not.
  /// @throws InputError where there is none
  std::string newest(std::vector<std::string>& damaged) const;

 private:
  void publish(const std::string& path) const;

  std::string folder_;
  int keep_;
};

/// Opens a checkpoint after looking at its seal, and reads its label.
/// @throws InputError where it is damaged or of another version
CheckpointLabel read_label(const std::string& path);
/// Only looks whether it is whole.
/// @throws InputError if not
void check_checkpoint(const std::string& path);

}  // namespace washtub
