#include "contact/untangle.hpp"

#include <algorithm>
#include <limits>
#include <map>

#include "cloth/crossings.hpp"
#include "cloth/face_normal.hpp"
#include "cloth/surface.hpp"
#include "contact/pair_list.hpp"

namespace washtub {
namespace {

constexpr int most_rounds = 1000;
constexpr double stride = 0.02;    // of a piece's extent, that it moves in a round
constexpr double margin = 1.05;    // of the gap
constexpr double touching = 1e-3;  // of the gap: the way between nearer pieces tells nothing

/// Pairs of pieces that conflict, each with the direction in which the first one leaves.
template <int D>
using Conflicts = std::map<std::array<int, 2>, Vec<D>>;

template <int D>
class Untangling {
 public:
  Untangling(Cloth<D>& cloth, const Mesh<D>& mesh, double gap,
             const std::function<bool(int, const Vec<D>&)>& allowed)
      : cloth_(cloth),
        mesh_(mesh),
        gap_(gap),
        allowed_(allowed),
        surface_(cloth),
        moved_(static_cast<std::size_t>(cloth.pieces()), Vec<D>::Zero()) {}

  bool run() {
    for (int round = 0; round < most_rounds; ++round) {
      const Conflicts<D> found = conflicts();
      if (found.empty()) return true;
      for (const auto& [pieces, way] : found)
        if (pieces[0] == pieces[1] || !part(pieces, way)) return false;
    }
    return false;
  }

 private:
  Conflicts<D> conflicts() const {
    Conflicts<D> found;
    std::vector<Vec<D>> x;
    if (!surface_.place(cloth_.position, x)) return found;
    PairList<D> list(surface_, mesh_, 0);
    list.cover(x, x, margin * gap_);
    for (const Pair<D>& pair : list.pairs()) {
      const Vec<D> gap = nearest<D>(pair.split, pair.places(x)).gap;
      const auto piece = [&](int point) { return surface_.piece[static_cast<std::size_t>(point)]; };
      const int a = piece(pair.point.front()), b = piece(pair.point.back());
      if (gap.norm() >= (a == b ? 1 : margin) * gap_) continue;
      Vec<D>& way = found.try_emplace({std::min(a, b), std::max(a, b)}, gap).first->second;
      if (gap.norm() <= way.norm()) way = a < b ? gap : Vec<D>(-gap);
    }
    for (auto& [pieces, way] : found)
      if (way.norm() < touching * gap_) way = way_out(pieces[0], pieces[1], x);
    for (const auto& pieces : find_crossings(cloth_, mesh_).pieces)
      found[pieces] = way_out(pieces[0], pieces[1], x);
    return found;
  }

  /// The direction in which the first of two pieces has the shortest way until all of it is on one
  /// side of the other: along the mean normal of either, or the line of their centres.
  Vec<D> way_out(int a, int b, const std::vector<Vec<D>>& x) const {
    Vec<D> between = centre(a) - centre(b);
    between -= mesh_.periods_in(between);
    Vec<D> best = Vec<D>::Unit(D - 1);
    double shortest = std::numeric_limits<double>::infinity();
    for (const Vec<D>& direction : {mean_normal(a, x), mean_normal(b, x), between}) {
      if (!(direction.norm() > 1e-9 * extent(a))) continue;
      const Vec<D> n = direction.normalized();
      const auto [low_a, high_a] = range(a, n);
      const auto [low_b, high_b] = range(b, n);
      const double along = between.dot(n) - (centre(a) - centre(b)).dot(n);
      const double forth = high_b - low_a - along, back = high_a + along - low_b;
      if (std::min(forth, back) >= shortest) continue;
      shortest = std::min(forth, back);
      best = forth <= back ? n : Vec<D>(-n);
    }
    return best;
  }
  /// Of the faces, weighed with their area.
  Vec<D> mean_normal(int piece, const std::vector<Vec<D>>& x) const {
    Vec<D> sum = Vec<D>::Zero();
    const auto p = static_cast<std::size_t>(piece);
    for (int f = surface_.first_face[p]; f < surface_.first_face[p + 1]; ++f)
      sum += face_normal<D>(surface_.faces[static_cast<std::size_t>(f)], x);
    return sum;
  }
  /// Where a piece lies along a direction, from and to [m].
  std::array<double, 2> range(int piece, const Vec<D>& along) const {
    std::array<double, 2> range{std::numeric_limits<double>::infinity(),
                                -std::numeric_limits<double>::infinity()};
    for (const Vec<D>& x : nodes(piece)) {
      range[0] = std::min(range[0], x.dot(along));
      range[1] = std::max(range[1], x.dot(along));
    }
    return range;
  }
  Vec<D> centre(int piece) const {
    Vec<D> sum = Vec<D>::Zero();
    for (const Vec<D>& x : nodes(piece)) sum += x;
    return sum / static_cast<double>(nodes(piece).size());
  }
  std::span<Vec<D>> nodes(int piece) const {
    const auto& group = group_of(piece);
    return std::span(cloth_.position)
        .subspan(static_cast<std::size_t>(group.node(piece - group.first_piece, 0)),
                 static_cast<std::size_t>(group.sheet.nodes()));
  }
  const ClothGroup<D>& group_of(int piece) const {
    return *std::find_if(cloth_.groups.begin(), cloth_.groups.end(), [&](const auto& group) {
      return piece < group.first_piece + group.pieces;
    });
  }
  double extent(int piece) const {
    const auto& sheet = group_of(piece).sheet;
    return std::max(sheet.spacing[0] * sheet.intervals(0), sheet.spacing[1] * sheet.intervals(1));
  }

  /// Moves both pieces half of the way, or one of them all of it. False where neither may.
  bool part(const std::array<int, 2>& pieces, const Vec<D>& way) {
    const double step = std::max(gap_, stride * std::min(extent(pieces[0]), extent(pieces[1])));
    const Vec<D> whole = step * way.normalized();
    const bool first = may(pieces[0], 0.5 * whole), second = may(pieces[1], -0.5 * whole);
    if (first && second) return move(pieces[0], 0.5 * whole), move(pieces[1], -0.5 * whole), true;
    if (may(pieces[0], whole)) return move(pieces[0], whole), true;
    if (may(pieces[1], -whole)) return move(pieces[1], -whole), true;
    return false;
  }
  bool may(int piece, const Vec<D>& way) const {
    return group_of(piece).pinned.empty() &&
           allowed_(piece, moved_[static_cast<std::size_t>(piece)] + way);
  }
  void move(int piece, const Vec<D>& way) {
    moved_[static_cast<std::size_t>(piece)] += way;
    for (Vec<D>& x : nodes(piece)) x += way;
  }

  Cloth<D>& cloth_;
  const Mesh<D>& mesh_;
  double gap_;
  const std::function<bool(int, const Vec<D>&)>& allowed_;
  ClothSurface<D> surface_;
  std::vector<Vec<D>> moved_;  ///< of each piece, in all [m]
};

}  // namespace

template <int D>
bool untangle(Cloth<D>& cloth, const Mesh<D>& mesh, double gap,
              const std::function<bool(int, const Vec<D>&)>& allowed) {
  return Untangling<D>(cloth, mesh, gap, allowed).run();
}

template bool untangle(Cloth<2>&, const Mesh<2>&, double,
                       const std::function<bool(int, const Vec<2>&)>&);
template bool untangle(Cloth<3>&, const Mesh<3>&, double,
                       const std::function<bool(int, const Vec<3>&)>&);

}  // namespace washtub
