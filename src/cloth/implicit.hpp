#pragma once
#include <array>
#include <span>
#include <vector>

#include "cloth/block_cholesky.hpp"
#include "cloth/sheet.hpp"

namespace washtub {

/// What holds the nodes of a group of equal pieces against their elastic forces. All spans are of
/// all pieces, one after the other.
template <int D>
struct ClothProblem {
  std::span<const Mat<D>> stiffness;  ///< K of each node [N/m], symmetric positive definite
  std::span<const Vec<D>> target;     ///< Z [m]
  /// X^n [m], a step `dt` [s] ago; looked at where the material has a loss time and dt > 0.
  std::span<const Vec<D>> before{};
  double dt = 0;
};

/// Implicit elastic update of a group of equal sheets, `lanes` of them at a time: for each piece
///   Y = argmin sum_i (Y_i - Z_i).K_i (Y_i - Z_i) / 2 + W(Y),
/// with K = m/dt^2 of a free node, so that K (Y - Z) = F = -dW/dX(Y). With a loss time W is the
/// potential of Kelvin's and Voigt's stress over the step, see elastic::Loss.
///
/// Newton iteration from Z. The first matrix is K plus the Hessian of W with springs under
/// compression kept only as far as the softest K of the piece outweighs them, which is positive
/// definite for any state; later ones take the full Hessian wherever that is positive definite. A
/// factor serves for as long as each step is at most `reuse` times the one before. Steps are halved
/// until the energy does not grow. Pieces converge and fail one by one.
template <int D>
class ClothSolver {
 public:
  struct Report {
    int iterations = 0;         ///< most Newton steps of any piece
    int factorisations = 0;     ///< of a batch, all batches together
    int failed = -1;            ///< first piece that did not converge; -1 if all did
    double largest_strain = 0;  ///< |E| of an edge of Y, over the pieces
  };

  /// @param pinned     nodes that stay at their target
  /// @param tolerance  stop when no component of a step exceeds it, in node spacings; Y depends to
  ///                   that extent on which pieces share a batch
  explicit ClothSolver(Sheet<D> sheet, const std::vector<int>& pinned = {},
                       double tolerance = D == 3 ? 1e-6 : 1e-7);

  /// On return Y of each piece listed satisfies the equation above to the tolerance, or, after
  /// `max_steps`, to a millionth of the node spacing; other pieces are untouched. A piece that
  /// failed keeps its last iterate, and the report names it. Allocates nothing.
  /// @param pieces  numbers of the pieces to solve
  /// @param Y       positions [m] and
  /// @param F       forces [N] of all pieces of the group
  Report solve(std::span<const int> pieces, const ClothProblem<D>& problem, std::span<Vec<D>> Y,
               std::span<Vec<D>> F);

  const Sheet<D>& sheet() const { return sheet_; }

 private:
  using PerLane = std::array<double, lanes>;
  using Field = LaneVector<double>;         ///< [node][component][lane]
  static constexpr int max_steps = 60;      ///< then a piece has failed, unless its last step is
  static constexpr double enough = 1e-6;    ///< in node spacings, or less
  static constexpr double reuse = 0.2;      ///< see above
  static constexpr double shortest = 1e-3;  ///< fraction of a step, below which a piece failed

  int piece(std::span<const int> pieces, int lane) const;
  void load(std::span<const int> pieces, const ClothProblem<D>& problem);
  void load(std::span<const int> pieces, std::span<const Vec<D>> from, Field& to) const;
  void find_loss(std::span<const int> pieces, const ClothProblem<D>& problem);
  void store(std::span<const int> pieces, const Field& from, std::span<Vec<D>> to) const;
  void report(std::span<const int> pieces, Report& out) const;
  int find_minimum();
  PerLane objective(const Field& X) const;
  int refactorise();
  void factorise(const PerLane& floor);
  void find_step();
  void measure_step();
  bool shrinks(const PerLane& previous) const;
  void find_pull(const Field& X, Field& pull) const;
  void drop_broken();
  void advance();
  bool retire();

  Sheet<D> sheet_;
  double tolerance_;  ///< [m]
  int springs_ = 0;   ///< most springs of the geometric Hessian that meet in a node
  BlockCholesky<D> cholesky_;
  Assembly<D> assembly_;
  Field X_, Z_, step_, trial_, ordered_;
  Field K_;     ///< [node][row][column][lane]
  Field past_;  ///< see elastic::Loss
  elastic::Loss loss_;

  PerLane objective_{}, size_{};    ///< [J]; largest component of the step [m]
  PerLane safe_floor_{};            ///< [N/m], see Sheet::hessian
  std::array<int, lanes> steps_{};  ///< taken so far
  std::array<bool, lanes> active_{}, failed_{};
};

}  // namespace washtub
