#pragma once
#include <array>
#include <span>
#include <vector>

#include "cloth/block_cholesky.hpp"
#include "cloth/sheet.hpp"

namespace washtub {

/// Implicit elastic update of a group of equal sheets, `lanes` of them at a time: for each piece
///   Y = argmin sum_i sum_c k_{i,c} (Y_{i,c} - Z_{i,c})^2 / 2 + W(Y),
/// with k = m/dt^2 per node and component, so that k (Y - Z) = -dW/dX(Y).
///
/// Newton iteration from Z. The first matrix is k plus the Hessian of W with springs under
/// compression kept only as far as the smallest k of the piece outweighs them, which is positive
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
  /// @param pieces     numbers of the pieces to solve
  /// @param stiffness  k [N/m] > 0, of all pieces of the group, piece after piece; likewise
  /// @param target     Z [m] and
  /// @param Y          positions [m]
  Report solve(std::span<const int> pieces, std::span<const Vec<D>> stiffness,
               std::span<const Vec<D>> target, std::span<Vec<D>> Y);

  const Sheet<D>& sheet() const { return sheet_; }

 private:
  using PerLane = std::array<double, lanes>;
  using Field = LaneVector<double>;         ///< [node][component][lane]
  static constexpr int max_steps = 60;      ///< then a piece has failed, unless its last step is
  static constexpr double enough = 1e-6;    ///< in node spacings, or less
  static constexpr double reuse = 0.2;      ///< see above
  static constexpr double shortest = 1e-3;  ///< fraction of a step, below which a piece failed

  int piece(std::span<const int> pieces, int lane) const;
  void load(std::span<const int> pieces, std::span<const Vec<D>> stiffness,
            std::span<const Vec<D>> target);
  void store(std::span<const int> pieces, std::span<Vec<D>> Y) const;
  void report(std::span<const int> pieces, Report& out) const;
  int find_minimum();
  PerLane objective(const Field& X) const;
  int refactorise();
  void factorise(const PerLane& floor);
  void find_step();
  void measure_step();
  bool shrinks(const PerLane& previous) const;
  void drop_broken();
  void advance();
  bool retire();

  Sheet<D> sheet_;
  double tolerance_;  ///< [m]
  int springs_ = 0;   ///< most springs of the geometric Hessian that meet in a node
  BlockCholesky<D> cholesky_;
  Assembly<D> assembly_;
  Field X_, Z_, k_, step_, trial_, ordered_;

  PerLane objective_{}, size_{};    ///< [J]; largest component of the step [m]
  PerLane safe_floor_{};            ///< [N/m], see Sheet::hessian
  std::array<int, lanes> steps_{};  ///< taken so far
  std::array<bool, lanes> active_{}, failed_{};
};

}  // namespace washtub
