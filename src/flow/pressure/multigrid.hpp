#pragma once
#include <algorithm>
#include <array>
#include <memory>
#include <span>
#include <vector>

#include "flow/pressure/conjugate_gradients.hpp"
#include "flow/pressure/gather.hpp"
#include "flow/pressure/hierarchy.hpp"
#include "flow/pressure/level.hpp"

namespace washtub {

/// Cells [begin, end) of a row.
struct RowRange {
  int begin, end;
};

/// Geometric multigrid for the pressure of a partly solid box,
///   sum over faces of  phi (p - p_neighbour) / (rho h^2)  =  b ,
/// with phi the open fraction of each face: closed faces carry no pressure gradient, Eq. (9) in the
/// sharp limit. The residual is taken in double precision, its correction by an F-cycle in single
/// precision; where pockets of fluid make these stall, flexible conjugate gradients take over with
/// the cycle as preconditioner.
template <int D>
class Multigrid {
 public:
  /// `open[d]`: open fractions of the lower faces along axis d, ghosts included, kept by the
  /// caller.
  Multigrid(const Grid<D>& grid, double density, std::array<const float*, D> open);
  ~Multigrid();

  /// Takes up changed open fractions of the planes [k0, k1) of this rank (collective).
  void update(int k0, int k1);
  void update() { update(0, levels_.front().block.planes()); }

  Storage<double>& pressure() { return problem_.x; }
  const Storage<double>& pressure() const { return problem_.x; }
  Storage<double>& source() { return problem_.b; }
  /// Live range of row (j, k); outside it every cell is solid.
  RowRange live(int j, int k) const {
    const auto& finest = levels_.front();
    const auto r = static_cast<std::size_t>(finest.block.row_index(j, k));
    return {finest.begin[r], finest.end[r]};
  }
  /// Zeroes a field outside the live ranges of the planes [k0, k1).
  template <class T>
  void clear_solid(Storage<T>& field, int k0, int k1) const {
    const auto& block = grid_.block();
    for (int k = k0; k < k1; ++k)
      for (int j = 0; j < block.rows(); ++j) {
        const auto [begin, end] = live(j, k);
        T* row = field.data() + block.row(j, k);
        std::fill_n(row, begin, T{0});
        std::fill(row + end, row + block.width(), T{0});
      }
  }
  const float* inverse_diagonal() const { return levels_.front().inverse_diagonal.data(); }

  /// Improves pressure() until the residual is within `tolerance`.
  /// On return the ghosts of the pressure are current.
  SolveReport solve(const Tolerance& tolerance, int max_cycles);

 private:
  enum class Start { set, add };
  enum class Cycle { full, simple };

  Block<D> coarse_block(std::size_t l, const Coarsening<D>& level, const Block<D>& finer);
  void make_level(std::size_t l, const Coarsening<D>& level, const Block<D>& block, double density);
  void coarsen_open(std::size_t l, int K0, int K1);
  template <class AddRow>
  void restrict_plane(std::size_t l, int K, AddRow&& add_row);
  void restrict_source(std::size_t l);
  void gather_source(std::size_t l);
  template <class Finish>
  void smooth(std::size_t l, Start start, int sweeps, Finish&& finish);
  void solve_coarsest();
  void solve_level(std::size_t l, Cycle cycle);
  ResidualSize take_residual(int K);
  void add_correction(int k);
  ResidualSize correct();
  void cycle_from_zero();
  void count_live(int k0, int k1);

  const Grid<D>& grid_;
  std::vector<Level<D>> levels_;  ///< from the finest on
  Problem<D> problem_;
  std::vector<std::array<Storage<float>, D>> coarse_open_;  ///< of the levels but the finest
  std::size_t first_gathered_;
  std::unique_ptr<GatherBlocks<D>> gather_;
  std::vector<float> row_sum_;
  std::vector<int> live_;          ///< live cells in each row of the finest level
  double live_cells_ = 0;          ///< on this rank
  MPI_Comm self_ = MPI_COMM_NULL;  ///< this rank alone, for levels that it holds whole
  ConjugateGradients<D> krylov_;
};

}  // namespace washtub
