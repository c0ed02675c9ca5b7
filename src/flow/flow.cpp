#include "flow/flow.hpp"

#include <algorithm>

namespace washtub {
namespace {

template <int D>
std::array<double*, D> pointers(std::array<Field, D>& fields) {
  std::array<double*, D> p;
  for (int d = 0; d < D; ++d) p[d] = fields[d].data();
  return p;
}

}  // namespace

template <int D>
Flow<D>::Flow(const Grid<D>& grid, double density, double viscosity,
              const std::array<std::array<Side<D>, 2>, D>& sides, const Openings<D>& openings)
    : grid_(grid),
      density_(density),
      viscosity_(viscosity),
      sides_(grid, sides),
      openings_(openings),
      multigrid_(grid, density, openings.open),
      pressure_before_(grid.make_field()) {
  for (int d = 0; d < D; ++d) {
    u_[d] = grid.make_field();
    f_[d] = grid.make_field();
    rhs_[d] = grid.make_field();
    convection_[d] = grid.make_field();
    if (openings.smooth) target_[d] = grid.make_field();
  }
  row_buffer_.resize(static_cast<std::size_t>(grid.block().width()) + 16);
  for (int c = 0; c < 2; ++c)
    for (std::size_t i = 0; i < row_buffer_.size(); ++i)
      colour_[c].push_back(static_cast<int>(i & 1) == c ? 1.0 : 0.0);
  refresh_ghosts();
}

template <int D>
void Flow<D>::exchange_velocity() {
  const auto u = pointers<D>(u_);
  grid_.halo().exchange(std::span<double* const>(u));
}

template <int D>
void Flow<D>::refresh_ghosts() {
  exchange_velocity();
  for (int c = 0; c < D; ++c) sides_.mirror(c, u_[c].data());
}

template <int D>
void Flow<D>::openings_changed(int k0, int k1, bool flipped) {
  multigrid_.update(k0, k1);
  if (flipped) steps_since_flip_ = -1;
  const auto& block = grid_.block();
  for (int k = k0; k < k1; ++k)
    for (int j = 0; j < block.rows(); ++j) {  // nothing is left behind in cells now solid
      const auto range = multigrid_.live(j, k);
      const int begin = range.begin, end = range.end;
      const auto clear = [&](Field& field) {
        double* row = field.data() + block.row(j, k);
        std::fill_n(row, begin, 0.0);
        std::fill(row + end, row + block.width(), 0.0);
      };
      clear(multigrid_.pressure());
      for (auto& c : convection_) clear(c);
    }
}

template class Flow<2>;
template class Flow<3>;

}  // namespace washtub
