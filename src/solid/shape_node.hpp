#pragma once
#include "solid/shape.hpp"

namespace washtub {

/// One kind of shape. psi is called for millions of points: no allocation, no exceptions.
struct Shape::Node {
  virtual ~Node() = default;
  virtual double psi(const Vec<3>& x) const = 0;
  virtual Bounds bounds() const = 0;
  virtual bool exact_outside() const { return true; }
};

}  // namespace washtub
