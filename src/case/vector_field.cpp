#include "case/vector_field.hpp"

#include <fmt/format.h>

#include <cmath>

#include "base/error.hpp"
#include "base/format.hpp"

namespace washtub {

template <int D>
VectorField<D>::VectorField(const std::array<std::string, 3>& formulas, std::string what)
    : texts_(formulas), what_(std::move(what)) {
  for (int d = 0; d < D; ++d) formulas_.emplace_back(formulas[d], formula_variables(D, true));
}

template <int D>
Vec<D> VectorField<D>::operator()(const Vec<D>& x, double t) const {
  std::array<double, D + 2> values;
  for (int d = 0; d < D; ++d) values[d] = x[d];
  values[D] = std::hypot(x[0], x[1]);
  values[D + 1] = t;
  Vec<D> u;
  for (int d = 0; d < D; ++d) {
    u[d] = formulas_[d](values);
    if (!std::isfinite(u[d]))
      throw InputError(
          fmt::format("{} \"{}\" is not finite at x = {:.6g} m, y = {:.6g} "
                      "m, t = {:.6g} s; try a < b ? c : d",
                      what_, texts_[d], x[0], x[1], t));
  }
  return u;
}

template class VectorField<2>;
template class VectorField<3>;

}  // namespace washtub
