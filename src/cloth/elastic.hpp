#pragma once
#include <cmath>

#include "cloth/sheet.hpp"

/// Energy and force of L sheets of one topology at once. A state is [node][component][lane]; with
/// L = 1 that is a plain array of Vec<D>. The loops over lanes are what the compiler vectorises.
namespace washtub::elastic {

/// Vectors along the legs of a strain, d[leg][component][lane] [m].
template <int D, int L, int N>
struct Legs {
  alignas(64) double d[N][D][L];

  template <bool seam>
  Legs(const Strain<D, N, seam>& e, const double* X) {
    for (int k = 0; k < N; ++k) {
      const double* a = X + e.leg[k][0] * D * L;
      const double* b = X + e.leg[k][1] * D * L;
#pragma omp simd
      for (int i = 0; i < D * L; ++i) (&d[k][0][0])[i] = b[i] - a[i];
      if constexpr (seam)
        for (int i = 0; i < D * L; ++i) (&d[k][0][0])[i] += e.shift[k][i / L];
    }
  }

  /// The strain E of each lane.
  template <bool seam>
  void strain(const Strain<D, N, seam>& e, double* E) const {
#pragma omp simd
    for (int l = 0; l < L; ++l) {
      double sum = e.offset;
      for (int k = 0; k < N; ++k)
        for (int c = 0; c < D; ++c) sum += e.weight[k] * d[k][c][l] * d[k][c][l];
      E[l] = sum;
    }
  }
};

template <int D, int L, int N, bool seam>
void add_energy(const Strain<D, N, seam>& e, const double* X, double* W) {
  alignas(64) double E[L];
  Legs<D, L, N>(e, X).strain(e, E);
#pragma omp simd
  for (int l = 0; l < L; ++l) W[l] += 0.5 * e.stiffness * E[l] * E[l];
}

template <int D, int L, int N, bool seam>
void add_force(const Strain<D, N, seam>& e, const double* X, double* F) {
  alignas(64) double E[L];
  const Legs<D, L, N> legs(e, X);
  legs.strain(e, E);
  for (int k = 0; k < N; ++k) {
    double* a = F + e.leg[k][0] * D * L;
    double* b = F + e.leg[k][1] * D * L;
    const double factor = 2 * e.weight[k] * e.stiffness;
    for (int c = 0; c < D; ++c) {
#pragma omp simd
      for (int l = 0; l < L; ++l) {
        const double pull = factor * E[l] * legs.d[k][c][l];
        a[c * L + l] += pull;
        b[c * L + l] -= pull;
      }
    }
  }
}

/// The second difference v[component][lane] of a bend.
template <int D, int L, bool seam>
void difference(const Bend<D, seam>& e, const double* X, double* v) {
  for (int i = 0; i < D * L; ++i) {
    if constexpr (seam)
      v[i] = e.shift[i / L];
    else
      v[i] = 0;
  }
  for (int k = 0; k < e.count; ++k) {
    const double* x = X + e.node[k] * D * L;
    const double w = e.weight[k];
#pragma omp simd
    for (int i = 0; i < D * L; ++i) v[i] += w * x[i];
  }
}

template <int D, int L, bool seam>
void add_energy(const Bend<D, seam>& e, const double* X, double* W) {
  alignas(64) double v[D * L];
  difference<D, L>(e, X, v);
  for (int c = 0; c < D; ++c) {
#pragma omp simd
    for (int l = 0; l < L; ++l) W[l] += 0.5 * e.stiffness * v[c * L + l] * v[c * L + l];
  }
}

template <int D, int L, bool seam>
void add_force(const Bend<D, seam>& e, const double* X, double* F) {
  alignas(64) double v[D * L];
  difference<D, L>(e, X, v);
  for (int k = 0; k < e.count; ++k) {
    double* f = F + e.node[k] * D * L;
    const double w = e.stiffness * e.weight[k];
#pragma omp simd
    for (int i = 0; i < D * L; ++i) f[i] -= w * v[i];
  }
}

template <int D, int L, bool seam>
void add_energy(const Elements<D, seam>& elements, const double* X, double* W) {
  for (const auto& e : elements.edges) add_energy<D, L>(e, X, W);
  for (const auto& e : elements.shears) add_energy<D, L>(e, X, W);
  for (const auto& e : elements.dilations) add_energy<D, L>(e, X, W);
  for (const auto& e : elements.bends) add_energy<D, L>(e, X, W);
}

template <int D, int L, bool seam>
void add_force(const Elements<D, seam>& elements, const double* X, double* F) {
  for (const auto& e : elements.edges) add_force<D, L>(e, X, F);
  for (const auto& e : elements.shears) add_force<D, L>(e, X, F);
  for (const auto& e : elements.dilations) add_force<D, L>(e, X, F);
  for (const auto& e : elements.bends) add_force<D, L>(e, X, F);
}

/// Adds the elastic energy of each lane to W[lane].
template <int D, int L>
void add_energy(const Sheet<D>& sheet, const double* X, double* W) {
  add_energy<D, L>(sheet.inner, X, W);
  add_energy<D, L>(sheet.seam, X, W);
}

/// Adds -dW/dX of each lane to F.
template <int D, int L>
void add_force(const Sheet<D>& sheet, const double* X, double* F) {
  add_force<D, L>(sheet.inner, X, F);
  add_force<D, L>(sheet.seam, X, F);
}

/// Largest |E| over the edges, per lane.
template <int D, int L>
void largest_strain(const Sheet<D>& sheet, const double* X, double* largest) {
  for (int l = 0; l < L; ++l) largest[l] = 0;
  const auto over = [&](const auto& edges) {
    alignas(64) double E[L];
    for (const auto& e : edges) {
      Legs<D, L, 1>(e, X).strain(e, E);
      for (int l = 0; l < L; ++l) largest[l] = std::fmax(largest[l], std::fabs(E[l]));
    }
  };
  over(sheet.inner.edges);
  over(sheet.seam.edges);
}

}  // namespace washtub::elastic
