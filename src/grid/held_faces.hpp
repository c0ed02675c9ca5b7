#pragma once
#include <cstddef>
#include <vector>

namespace washtub {

/// A face whose velocity is held to that of a wall.
struct HeldFace {
  long p;              ///< memory position
  int row;             ///< of the block, Block::row_index
  int place;           ///< in its row
  double wall;         ///< velocity of the wall there [m/s]
  double share = 0;    ///< from 0 to 1, held at once in each step
  double drag = 0;     ///< diffusion towards the wall [1/m^2]
  double passage = 1;  ///< share of the face through which water goes past the wall, > 0
};

/// The held faces normal to one axis, in the order of memory.
class HeldFaces {
 public:
  /// @param rows  of the block
  explicit HeldFaces(int rows) : first_(static_cast<std::size_t>(rows) + 1, 0) {}

  /// A face that is looked at again; it takes part from the next update() on if it is held still.
  void look(long p) { looked_.push_back(p); }
  void hold(const HeldFace& face) { fresh_.push_back(face); }
  void clear() { faces_.clear(); }
  /// Takes up what was looked at and held since the last time.
  void update();

  /// Calls visit(face, its place in the list) for those of a row.
  template <class Visit>
  void for_row(int row, Visit&& visit) const {
    for (int n = first_[row]; n < first_[row + 1]; ++n) visit(faces_[n], n);
  }
  std::size_t size() const { return faces_.size(); }
  auto begin() const { return faces_.begin(); }
  auto end() const { return faces_.end(); }

 private:
  std::vector<HeldFace> faces_, fresh_, merged_;
  std::vector<long> looked_;
  std::vector<int> first_;  ///< of each row, and the end of the last
};

}  // namespace washtub
