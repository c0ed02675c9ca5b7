#pragma once
#include <memory>
#include <vector>

#include "base/vec.hpp"

namespace washtub {

/// Axis-aligned box that holds a shape; infinite where the shape is unbounded, and with
/// lower > upper where it is empty.
struct Bounds {
  Vec<3> lower, upper;  ///< [m]
};

/// A solid region given by its signed distance psi [m], positive inside (paper, section 3).
/// A value: copying is cheap, and a shape never changes. Two-dimensional cases evaluate at z = 0.
class Shape {
 public:
  struct Node;  // one kind of shape
  explicit Shape(std::shared_ptr<const Node> node) : node_(std::move(node)) {}
  Shape();  ///< empty: psi is minus infinity everywhere

  /// Signed distance, or for unions and intersections the usual bound of it: right sign, Lipschitz
  /// constant 1, never larger than the distance. Any number of threads may call it.
  double psi(const Vec<3>& x) const;
  Bounds bounds() const;
  /// Whether psi is the distance itself, not only its bound, wherever it is negative.
  bool exact_outside() const;

 private:
  std::shared_ptr<const Node> node_;
};

// Every maker throws an InputError that names the parameter where it is out of range.

Shape sphere(const Vec<3>& centre, double radius);
/// Upright cylinder about the z axis through the origin, between two heights (may be infinite).
Shape cylinder(double radius, double z_lower, double z_upper);
Shape box(const Vec<3>& lower, const Vec<3>& upper);  ///< corners may be infinite
/// Points nearer than `radius` to the segment from a to b.
Shape capsule(const Vec<3>& a, const Vec<3>& b, double radius);
/// Points with (x - point) . normal < 0; the normal need not be of unit length.
Shape half_space(const Vec<3>& point, const Vec<3>& normal);
/// Solid of revolution about z of a closed polygon of (r, z) vertices, r >= 0, that does not cross
/// itself. Edges on the axis are no surface.
Shape revolution(const std::vector<Vec<2>>& profile);
/// Plate in the plane y = 0: a closed polygon of (x, z) vertices that does not cross itself,
/// thickened to |y| < half_thickness.
Shape plate(const std::vector<Vec<2>>& outline, double half_thickness);

Shape unite(const std::vector<Shape>& shapes);      ///< psi = max, as in the paper; none: empty
Shape intersect(const std::vector<Shape>& shapes);  ///< psi = min; at least one shape
Shape subtract(const Shape& from, const Shape& what);
Shape complement(const Shape& shape);
Shape translate(const Shape& shape, const Vec<3>& by);
Shape rotate_z(const Shape& shape, double angle);  ///< angle [rad], about the origin

}  // namespace washtub
