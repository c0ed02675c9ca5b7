#include "flow/flow.hpp"

#include <algorithm>
#include <cmath>

namespace washtub {

template <int D>
Flow<D>::Flow(const Grid<D>& grid, double density, double viscosity, const SidePairs<D>& sides,
              const Openings<D>& openings)
    : grid_(grid),
      density_(density),
      viscosity_(viscosity),
      conditions_(sides),
      sides_(grid, sides),
      passing_(grid, sides),
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
std::array<double*, D> Flow<D>::velocities() {
  std::array<double*, D> u;
  for (int d = 0; d < D; ++d) u[d] = u_[d].data();
  return u;
}

template <int D>
void Flow<D>::exchange_velocity() {
  const auto u = velocities();
  grid_.halo().exchange(std::span<double* const>(u));
}

template <int D>
void Flow<D>::refresh_ghosts() {
  exchange_velocity();
  for (int c = 0; c < D; ++c) sides_.mirror(c, u_[c].data());
}

template <int D>
void Flow<D>::keep_prediction() {
  for (int d = 0; d < D; ++d) {
    if (prediction_[d].size() == 0) prediction_[d] = grid_.make_field();
    std::copy_n(u_[d].data(), u_[d].size(), prediction_[d].data());
  }
}

template <int D>
void Flow<D>::return_to_prediction() {
  for (int d = 0; d < D; ++d) std::copy_n(prediction_[d].data(), u_[d].size(), u_[d].data());
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

template <int D>
void Flow<D>::restart() {
  for (int d = 0; d < D; ++d) {
    f_[d].fill(0);
    convection_[d].fill(0);
  }
  multigrid_.pressure().fill(0);
  pressure_before_.fill(0);
  last_step_ = 0;
  steps_since_flip_ = -1;
  forced_ = false;
}

template <int D>
void Flow<D>::state(Archive& archive) {
  const GridPart part = grid_.part();
  archive.grids("velocity", u_, part);
  archive.grids("force", f_, part);
  archive.grids("convection", convection_, part);
  archive.grid("pressure", multigrid_.pressure(), part);
  archive.grid("pressure before", pressure_before_, part);
  archive.value("last step", last_step_);
  archive.value("speed", speed_);
  archive.value("steps since flip", steps_since_flip_);
  archive.value("forced", forced_);
  archive.value("passing water", passing_);
  if (archive.reading()) multigrid_.update();
}

template class Flow<2>;
template class Flow<3>;

}  // namespace washtub
