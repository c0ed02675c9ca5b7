#include "flow/fields.hpp"

#include <algorithm>

namespace washtub {
namespace {

/// Calls visit(cell) for the cells of the block and its ghosts.
template <int D, class Visit>
void for_cells_and_ghosts(const Block<D>& block, Visit&& visit) {
  Index<D> c{};
  const int j0 = D == 3 ? -1 : 0, j1 = D == 3 ? block.rows() + 1 : 1;
  for (int k = -1; k <= block.planes(); ++k)
    for (int j = j0; j < j1; ++j)
      for (int i = -1; i <= block.width(); ++i) {
        c[0] = i;
        if constexpr (D == 3) c[1] = j;
        c[D - 1] = k;
        visit(c);
      }
}

}  // namespace

template <int D>
FlowFields<D>::FlowFields(const Grid<D>& grid_, double density_, double viscosity_,
                          const SidePairs<D>& sides_, const Openings<D>& openings_)
    : grid(grid_),
      density(density_),
      viscosity(viscosity_),
      conditions(sides_),
      sides(grid, conditions),
      passing(grid, conditions),
      openings(openings_) {
  for (int d = 0; d < D; ++d) {
    u[d] = grid.make_field();
    f[d] = grid.make_field();
  }
  refresh_ghosts();
}

template <int D>
std::array<double*, D> FlowFields<D>::velocities() {
  std::array<double*, D> values;
  for (int d = 0; d < D; ++d) values[d] = u[d].data();
  return values;
}

template <int D>
void FlowFields<D>::to_passage(int j, int k) {
  const int row = grid.block().row_index(j, k);
  for (int c = 0; c < D; ++c) {
    past[c].resize(openings.held[c]->size());
    openings.held[c]->for_row(row, [&](const HeldFace& face, int n) {
      double& v = u[c][face.p];
      past[c][n] = v - face.wall;
      v = face.wall + face.passage * past[c][n];
    });
  }
}

template <int D>
void FlowFields<D>::from_passage() {
  for (int c = 0; c < D; ++c) {
    int n = 0;
    for (const auto& face : *openings.held[c]) {
      const double before = face.wall + face.passage * past[c][n];
      u[c][face.p] = face.wall + past[c][n] + (u[c][face.p] - before) / face.passage;
      ++n;
    }
  }
}

template <int D>
void FlowFields<D>::exchange() {
  grid.halo().exchange(u);
}

template <int D>
void FlowFields<D>::refresh_ghosts() {
  exchange();
  for (int c = 0; c < D; ++c) sides.mirror(c, u[c].data());
}

template <int D>
void FlowFields<D>::set_velocity(const std::function<Vec<D>(const Vec<D>&)>& field) {
  using Kind = typename Side<D>::Kind;
  const auto& block = grid.block();
  for (int d = 0; d < D; ++d)
    for_cells_and_ghosts(block, [&](const Index<D>& c) {
      bool sets = openings.open[d][block.at(c)] > 0;
      for (int a = 0; a < D; ++a)
        for (int s = 0; s < 2; ++s) {
          const int beyond = s == 0 ? (a == d ? 0 : -1) : block.count[a];
          if (c[a] != beyond || !grid.at_side(a, s)) continue;
          const Kind kind = conditions[a][s].kind;
          sets = kind == Kind::outflow || kind == Kind::far_field;
        }
      if (sets) u[d][block.at(c)] = field(grid.position(c, d))[d];
    });
  refresh_ghosts();
  speed = 0;
  for (int d = 0; d < D; ++d)
    for (int k = 0; k < block.planes(); ++k)
      for (int j = 0; j < block.rows(); ++j) {
        const double* row = u[d].data() + block.row(j, k);
        for (int i = 0; i < block.width(); ++i) speed = std::max(speed, std::abs(row[i]));
      }
  speed = grid.parallel().max(speed);
}

template <int D>
void FlowFields<D>::state(Archive& archive) {
  archive.grids("velocity", u, grid.part());
  archive.grids("force", f, grid.part());
  archive.value("speed", speed);
  archive.value("passing", passing);
}

template struct FlowFields<2>;
template struct FlowFields<3>;

}  // namespace washtub
