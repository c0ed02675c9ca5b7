#pragma once
#include <array>
#include <string>
#include <vector>

#include "base/expression.hpp"
#include "base/vec.hpp"

namespace washtub {

/// A vector given by a formula per axis, of x, y, z, r and t.
template <int D>
class VectorField {
 public:
  /// @param what  it is, as errors call it
  /// @throws InputError when a formula cannot be read
  VectorField(const std::array<std::string, 3>& formulas, std::string what);

  /// The vector, in SI units, at x [m] and time t [s].
  /// @throws InputError where it is not finite
  Vec<D> operator()(const Vec<D>& x, double t = 0) const;

 private:
  std::array<std::string, 3> texts_;
  std::string what_;
  std::vector<Expression> formulas_;
};

}  // namespace washtub
