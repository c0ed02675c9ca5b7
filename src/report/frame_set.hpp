#pragma once
#include <map>
#include <string>
#include <vector>

#include "io/frame_reader.hpp"

namespace washtub {

/// The frames of a run, all but their water, which is too much to be kept.
struct FrameSet {
  std::string directory;
  std::vector<int> numbers;                           ///< of the files
  std::vector<double> times;                          ///< [s]
  std::map<std::string, std::vector<double>> angles;  ///< per solid and frame [rad]
  std::array<int, 3> cells{};                         ///< of the water
  std::vector<ClothFrame::Piece> pieces;
  std::size_t nodes = 0;  ///< of all pieces together
  /// [frame][axis][node], m
  std::vector<std::vector<float>> positions;
  /// A scalar of the nodes in each frame.
  struct NodeField {
    FieldDescription field;
    std::vector<std::vector<float>> values;  ///< [frame][node]
  };
  std::vector<NodeField> fields;
  std::vector<std::string> notes;  ///< sentences on frames that were left out

  std::size_t size() const { return times.size(); }
};

/// Frames that cannot be read, are not shaped like the first one, or have cloth at places that are
/// not finite are left out and noted.
FrameSet read_frames(const std::string& directory);

/// "frames 3, 4, 7, 8, 9 and 5 more"; names only the first few.
std::string frame_list(const std::vector<int>& numbers);

/// Lower and upper corner of the box around all cloth of some frames [m]; both 0 where there is
/// none.
std::array<Vec<3>, 2> cloth_span(const FrameSet& frames, const std::vector<std::size_t>& shown);

}  // namespace washtub
