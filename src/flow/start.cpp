#include <algorithm>

#include "flow/flow.hpp"

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
void Flow<D>::set_velocity(const std::function<Vec<D>(const Vec<D>&)>& field) {
  using Kind = typename Side<D>::Kind;
  const auto& block = grid_.block();
  for (int d = 0; d < D; ++d) {
    double* u = u_[d].data();
    const float* open = openings_.open[d];
    for_cells_and_ghosts(block, [&](const Index<D>& c) {
      bool sets = open[block.at(c)] > 0;
      for (int a = 0; a < D; ++a)
        for (int s = 0; s < 2; ++s) {
          const int beyond = s == 0 ? (a == d ? 0 : -1) : block.count[a];
          if (c[a] != beyond || !grid_.at_side(a, s)) continue;
          const Kind kind = conditions_[a][s].kind;
          sets = kind == Kind::outflow || kind == Kind::far_field;
        }
      if (sets) u[block.at(c)] = field(grid_.position(c, d))[d];
    });
  }
  refresh_ghosts();
  double speed = 0;
  for (int d = 0; d < D; ++d)
    for (int k = 0; k < block.planes(); ++k)
      for (int j = 0; j < block.rows(); ++j) {
        const double* u = u_[d].data() + block.row(j, k);
        for (int i = 0; i < block.width(); ++i) speed = std::max(speed, std::abs(u[i]));
      }
  speed_ = grid_.parallel().max(speed);
}

template class Flow<2>;
template class Flow<3>;

}  // namespace washtub
