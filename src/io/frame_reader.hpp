#pragma once
#include <array>
#include <cstdint>
#include <string>
#include <vector>

#include "io/frame.hpp"
#include "io/hdf5_handle.hpp"

namespace washtub {

/// Numbers that have no file, both ends included.
struct FrameGap {
  int first, last;
  bool operator==(const FrameGap&) const = default;
};

/// The frames of an output directory.
struct FrameFiles {
  std::vector<int> numbers;    ///< ascending
  std::vector<FrameGap> gaps;  ///< below the last number
};

/// Files named as frame_path names them; empty where the directory has no folder "frames".
FrameFiles frame_files(const std::string& directory);

/// Where FrameWriter puts frame `number`.
std::string frame_path(const std::string& directory, int number);

/// All pieces of cloth in a frame, one after the other.
struct ClothFrame {
  struct Piece {
    int first = 0;              ///< node
    std::array<int, 2> extent;  ///< nodes along r and s; {1, n} for a thread
    std::array<bool, 2> closed{};
    bool operator==(const Piece&) const = default;
  };
  std::vector<Piece> pieces;
  std::vector<double> positions;            ///< x y z per node [m]
  std::vector<FieldValues<double>> fields;  ///< per node, by their names in order

  std::size_t nodes() const { return positions.size() / 3; }
};

/// The water of a frame, x fastest.
struct WaterFrame {
  std::array<int, 3> cells{};              ///< third one 1 in plane cases
  std::vector<FieldValues<float>> fields;  ///< per cell, those of vectors one after the other
};

/// One file that FrameWriter has written, read by one process alone. Everything throws an
/// InputError with the path and what is wrong where the file is no whole frame.
class FrameReader {
 public:
  explicit FrameReader(const std::string& path);

  double time() const { return attribute("time [s]"); }  ///< [s]
  std::vector<SolidAngle> solids() const;
  ClothFrame cloth() const;  ///< no pieces where the run has no cloth
  std::array<int, 3> cells() const;
  /// The fields with these names; all of them where none is named.
  WaterFrame water(const std::vector<std::string>& names = {}) const;

 private:
  [[noreturn]] void fail(const std::string& what) const;
  double attribute(const std::string& name) const;
  std::vector<hsize_t> extent(const std::string& name) const;
  /// All values of a dataset; `type` is that of T.
  template <class T>
  std::vector<T> values(const std::string& name, hid_t type) const;
  std::vector<double> per_node(const std::string& name, std::size_t count) const;
  /// Names of the datasets of a group.
  std::vector<std::string> names(const std::string& group) const;
  /// What is stored of a field; `components` from its shape.
  FieldDescription field(const std::string& group, const std::string& name,
                         std::size_t components) const;
  std::string text(hid_t dataset, const char* name) const;
  std::uintmax_t bytes() const;  ///< of the file

  std::string path_;
  Hdf5Handle file_;
};

}  // namespace washtub
