#pragma once
#include <algorithm>
#include <utility>
#include <vector>

#include "cloth/elastic.hpp"

namespace washtub {

/// Where the D x D block (x, y) of a symmetric matrix is kept when only one triangle is: in block
/// `index`, as its transpose if `transposed`; nowhere if a node is pinned (index < 0).
struct Place {
  int index = -1;
  bool transposed = false;
};

/// All unordered pairs of nodes (x >= y) that an element of the sheet couples, sorted.
template <int D>
std::vector<std::pair<int, int>> couplings(const Sheet<D>& sheet);

/// Sums the Hessian of a sheet's energy into blocks [index][row][column][lane] whose places were
/// looked up once.
template <int D>
class Assembly {
 public:
  /// @param place  callable: place(x, y) is the Place of block (x, y), for every coupled pair
  template <class Locate>
  Assembly(const Sheet<D>& sheet, int blocks, const Locate& place);

  /// On return blocks = d2W/dX2 at X of each lane [N/m], springs under compression cut at
  /// floor[lane] <= 0.
  template <int L>
  void assemble(const double* X, const double* floor, double* blocks,
                elastic::Loss loss = {}) const;

 private:
  /// A pair of legs (first, second <= first) and the places of its four pairs of ends.
  struct Pair {
    int first, second;
    std::array<Place, 4> place;  ///< (a, a), (a, b), (b, a), (b, b)
  };
  template <int N>
  using Pairs = std::array<Pair, N*(N + 1) / 2>;

  template <int N, bool seam>
  struct Element {
    Strain<D, N, seam> strain;
    Pairs<N> pairs;
  };
  template <bool seam>
  struct Part {
    std::vector<Element<1, seam>> edges;
    std::vector<Element<2, seam>> shears;
    std::vector<Element<4, seam>> dilations;
  };

  template <int N, bool seam, class Locate>
  static std::vector<Element<N, seam>> locate(const std::vector<Strain<D, N, seam>>& strains,
                                              const Locate& place);
  template <bool seam, class Locate>
  static Part<seam> locate(const Elements<D, seam>& elements, const Locate& place);
  template <bool seam, class Locate>
  void add_bending(const std::vector<Bend<D, seam>>& bends, const Locate& place);
  template <int L, int N, bool seam>
  static void add(const Element<N, seam>& element, const double* X, const double* floor,
                  const elastic::Loss& loss, double* blocks);
  template <int L, bool seam>
  static void add(const Part<seam>& part, const double* X, const double* floor, elastic::Loss& loss,
                  double* blocks);
  template <int L>
  void start(double* blocks) const;

  Part<false> inner_;
  Part<true> seam_;
  std::vector<double> bending_;  ///< constant multiple of the identity in each block
};

template <int D>
template <int N, bool seam, class Locate>
auto Assembly<D>::locate(const std::vector<Strain<D, N, seam>>& strains, const Locate& place)
    -> std::vector<Element<N, seam>> {
  std::vector<Element<N, seam>> out;
  for (const auto& strain : strains) {
    Element<N, seam> element{strain, {}};
    int n = 0;
    for (int e = 0; e < N; ++e) {
      for (int f = 0; f <= e; ++f) {
        const auto& [a, b] = strain.leg[e];
        const auto& [c, d] = strain.leg[f];
        element.pairs[n++] = {e, f, {place(a, c), place(a, d), place(b, c), place(b, d)}};
      }
    }
    out.push_back(element);
  }
  return out;
}

template <int D>
template <bool seam, class Locate>
auto Assembly<D>::locate(const Elements<D, seam>& elements, const Locate& place) -> Part<seam> {
  return {locate(elements.edges, place), locate(elements.shears, place),
          locate(elements.dilations, place)};
}

template <int D>
template <class Locate>
Assembly<D>::Assembly(const Sheet<D>& sheet, int blocks, const Locate& place)
    : inner_(locate(sheet.inner, place)), seam_(locate(sheet.seam, place)), bending_(blocks, 0.0) {
  add_bending(sheet.inner.bends, place);
  add_bending(sheet.seam.bends, place);
}

template <int D>
template <bool seam, class Locate>
void Assembly<D>::add_bending(const std::vector<Bend<D, seam>>& bends, const Locate& place) {
  for (const auto& e : bends) {
    for (int m = 0; m < e.count; ++m) {
      for (int n = 0; n <= m; ++n) {
        const Place p = place(e.node[m], e.node[n]);
        if (p.index >= 0) bending_[p.index] += e.stiffness * e.weight[m] * e.weight[n];
      }
    }
  }
}

namespace elastic {

/// block += sign M, or sign M^T; both are [row][column][lane].
template <int D, int L>
void add_block(const double* M, double sign, bool transposed, double* block) {
  for (int r = 0; r < D; ++r) {
    for (int c = 0; c < D; ++c) {
      const double* m = M + (transposed ? c * D + r : r * D + c) * L;
      double* out = block + (r * D + c) * L;
#pragma omp simd
      for (int l = 0; l < L; ++l) out[l] += sign * m[l];
    }
  }
}

/// M = factor tangent u v^T.
template <int D, int L>
void outer(double factor, const double* tangent, const double (&u)[D][L], const double (&v)[D][L],
           double* M) {
  for (int r = 0; r < D; ++r) {
    alignas(64) double row[L];
#pragma omp simd
    for (int l = 0; l < L; ++l) row[l] = factor * tangent[l] * u[r][l];
    for (int c = 0; c < D; ++c) {
#pragma omp simd
      for (int l = 0; l < L; ++l) M[(r * D + c) * L + l] = row[l] * v[c][l];
    }
  }
}

/// M += max(factor stress, floor) I.
template <int D, int L>
void add_spring(double factor, const double* stress, const double* floor, double* M) {
  for (int r = 0; r < D; ++r) {
#pragma omp simd
    for (int l = 0; l < L; ++l) {
      const double spring = factor * stress[l];
      M[(r * D + r) * L + l] += spring > floor[l] ? spring : floor[l];
    }
  }
}

}  // namespace elastic

template <int D>
template <int L, int N, bool seam>
void Assembly<D>::add(const Element<N, seam>& element, const double* X, const double* floor,
                      const elastic::Loss& loss, double* blocks) {
  const Strain<D, N, seam>& e = element.strain;
  const elastic::Legs<D, L, N> legs(e, X);
  alignas(64) double E[L], M[D * D * L];
  legs.strain(e, E);
  const elastic::Response<L> response(e, loss, E);
  for (const Pair& pair : element.pairs) {
    const double w = 4 * e.weight[pair.first] * e.weight[pair.second];
    elastic::outer<D, L>(w, response.tangent, legs.d[pair.first], legs.d[pair.second], M);
    const bool same = pair.first == pair.second;
    if (same) elastic::add_spring<D, L>(2 * e.weight[pair.first], response.stress, floor, M);
    for (int k = 0; k < 4; ++k) {
      if (same && k == 2) continue;  // (b, a) is (a, b) again
      const Place& p = pair.place[k];
      if (p.index < 0) continue;
      const double sign = k == 0 || k == 3 ? 1 : -1;
      double* block = blocks + static_cast<std::ptrdiff_t>(p.index) * D * D * L;
      elastic::add_block<D, L>(M, sign, p.transposed, block);
      const int x = e.leg[pair.first][k / 2], y = e.leg[pair.second][k % 2];
      if (!same && x == y) elastic::add_block<D, L>(M, sign, true, block);
    }
  }
}

template <int D>
template <int L>
void Assembly<D>::start(double* blocks) const {
  for (const double bending : bending_) {
    for (int i = 0; i < D * D * L; ++i) blocks[i] = (i / L) % (D + 1) == 0 ? bending : 0.0;
    blocks += D * D * L;
  }
}

template <int D>
template <int L, bool seam>
void Assembly<D>::add(const Part<seam>& part, const double* X, const double* floor,
                      elastic::Loss& loss, double* blocks) {
  const auto over = [&](const auto& elements) {
    for (const auto& e : elements) add<L>(e, X, floor, loss, blocks), loss.next<L>();
  };
  over(part.edges);
  over(part.shears);
  over(part.dilations);
}

template <int D>
template <int L>
void Assembly<D>::assemble(const double* X, const double* floor, double* blocks,
                           elastic::Loss loss) const {
  start<L>(blocks);
  add<L>(inner_, X, floor, loss, blocks);
  add<L>(seam_, X, floor, loss, blocks);
}

}  // namespace washtub
