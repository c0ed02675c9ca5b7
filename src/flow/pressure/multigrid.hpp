#pragma once
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
/// sharp limit. Stationary F-cycles are the solver; where pockets of fluid make them stall,
/// flexible conjugate gradients take over with the cycle as preconditioner.
template <int D>
class Multigrid {
 public:
  /// `open[d]`: open fractions of the lower faces along axis d, ghosts included, kept by the
  /// caller.
  Multigrid(const Grid<D>& grid, double density, std::array<const float*, D> open);
  ~Multigrid();

  /// Takes up changed open fractions of the planes [k0, k1) of this rank (collective).
  void update(int k0, int k1);
  void update() { update(0, finest_.block.planes()); }

  Storage<double>& pressure() { return finest_.x; }
  const Storage<double>& pressure() const { return finest_.x; }
  Storage<double>& source() { return finest_.b; }
  /// Live range of row (j, k); outside it every cell is solid.
  RowRange live(int j, int k) const {
    const auto r = static_cast<std::size_t>(finest_.block.row_index(j, k));
    return {finest_.begin[r], finest_.end[r]};
  }
  /// Zeroes a field outside the live ranges of the planes [k0, k1).
  void clear_solid(Field& field, int k0, int k1) const;
  const float* inverse_diagonal() const { return finest_.inverse_diagonal.data(); }

  /// Improves pressure() until the residual is within `tolerance`.
  /// On return the ghosts of the pressure are current.
  SolveReport solve(const Tolerance& tolerance, int max_cycles);

 private:
  enum class Start { keep, set, add };

  Block<D> coarse_block(std::size_t l, const Coarsening<D>& level, const Block<D>& finer);
  void make_level(std::size_t l, const Coarsening<D>& level, const Block<D>& block, double density);
  template <class T>
  ResidualSize smooth(Level<D, T>& fine, std::size_t coarse, Start start, int sweeps,
                      bool residual);
  template <class T>
  ResidualSize restrict_plane(const Level<D, T>& fine, Level<D, float>& coarse, int K, bool source);
  template <class T>
  void restrict_source(const Level<D, T>& fine, std::size_t coarse);
  enum class Cycle { full, simple };
  void solve_level(std::size_t l, Cycle cycle);
  void solve_coarsest(Level<D, float>& l);
  template <class T>
  void coarsen_open(const Level<D, T>& fine, std::size_t coarse, int K0, int K1);
  void gather_source(std::size_t l);
  void cycle_from_zero();
  void count_live(int k0, int k1);

  const Grid<D>& grid_;
  Level<D, double> finest_;
  std::vector<Level<D, float>> coarse_;
  std::vector<std::array<Storage<float>, D>> coarse_open_;
  std::size_t first_gathered_;
  std::unique_ptr<GatherBlocks<D>> gather_;
  std::vector<float> row_sum_;
  std::vector<int> live_;          ///< live cells in each row of the finest level
  double live_cells_ = 0;          ///< on this rank
  MPI_Comm self_ = MPI_COMM_NULL;  ///< this rank alone, for levels that it holds whole
  ConjugateGradients<D> krylov_;
};

}  // namespace washtub
