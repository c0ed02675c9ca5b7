#pragma once
#include <span>
#include <vector>

#include "base/archive.hpp"
#include "measure/trajectory.hpp"

namespace washtub {

/// The scatter r' of the paper's Fig. 11, "the rms distance of all the cloth points from their time
/// and space average of the center of mass", in the (r, z) plane of its Figs. 8-10. The text leaves
/// open about which centre; both are given:
///   common(): about one centre, the mean of (r, z) over the area of all pieces and the window;
///   own():    of each piece about its own mean over its area and the window, then the rms over
///             the pieces (area-weighted). A piece spinning in its place adds only to this one its
///             own extent, while common() also holds how far apart the places are.
class Scatter {
 public:
  Scatter(std::size_t pieces, const Interval& window, const Vec<2>& axis)
      : window_(window), axis_(axis), r_(pieces), z_(pieces) {}

  /// One piece's nodes [m], standing for the time `over`; `area` per node with borders halved.
  template <int D>
  void add(const Interval& over, std::size_t piece, std::span<const Vec<D>> points,
           std::span<const double> area) {
    const double time = window_.overlap(over);
    if (time <= 0) return;
    for (std::size_t i = 0; i < points.size(); ++i) {
      const Vec<2> p = radius_height(points[i], axis_);
      r_[piece].add(p[0], area[i] * time);
      z_[piece].add(p[1], area[i] * time);
    }
  }

  /// All that another one of the same pieces has collected over its own window.
  void add(const Scatter& others);

  void state(Archive& archive) {
    archive.same_length("r", r_);
    archive.same_length("z", z_);
  }

  const Interval& window() const { return window_; }
  double common() const { return common_about(*this); }  ///< r' about the common centre [m]
  double own() const { return own_about(*this); }        ///< r' about each piece's own centre [m]
  /// The same about the centres of another window, mostly one that holds this one: over its whole
  /// cycles the mean of the squares of their scatter is the square of its own [m].
  double common_about(const Scatter& other) const;
  double own_about(const Scatter& other) const;
  Vec<2> centre() const;                   ///< the common centre (r, z) [m]
  Vec<2> centre(std::size_t piece) const;  ///< a piece's own centre (r, z) [m]

 private:
  /// Rms distance of all points from `centre(piece)`.
  template <class Centre>
  double rms_distance(const Centre& centre) const;

  Interval window_;
  Vec<2> axis_;
  std::vector<Statistics> r_, z_;
};

}  // namespace washtub
