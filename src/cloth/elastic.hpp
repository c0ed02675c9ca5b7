#pragma once
#include <cmath>

#include "cloth/sheet.hpp"

/// Energy and force of L sheets of one topology at once. A state is [node][component][lane]; with
/// L = 1 that is a plain array of Vec<D>. The loops over lanes are what the compiler vectorises.
namespace washtub::elastic {

/// Kelvin's and Voigt's law over a step dt: K (E + tau (E - E^n)/dt) is the stress of a spring of
/// `gain` K, gain = 1 + tau/dt, whose strain counts from `past` = E^n tau/(tau + dt).
struct Loss {
  double gain = 1;
  const double* past = nullptr;  ///< [strain][lane], in the order of the elements; null: 0

  /// That of the strain after this one.
  template <int L>
  void next() {
    if (past) past += L;
  }
};

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

/// How the energy of a strain depends on it, at E of each lane.
template <int L>
struct Response {
  alignas(64) double energy[L];   ///< [J]
  alignas(64) double stress[L];   ///< dW/dE [J]
  alignas(64) double tangent[L];  ///< d2W/dE2 [J]

  template <int D, int N, bool seam>
  Response(const Strain<D, N, seam>& e, const Loss& loss, const double* E) {
    const double stiffness = loss.gain * e.stiffness;
#pragma omp simd
    for (int l = 0; l < L; ++l) {
      const double strain = loss.past ? E[l] - loss.past[l] : E[l];
      energy[l] = 0.5 * stiffness * strain * strain;
      stress[l] = stiffness * strain;
      tangent[l] = stiffness;
    }
    if constexpr (N == 1) stiffen(e.beyond, E);
  }

 private:
  void stiffen(const Stiffening& beyond, const double* E) {
    if (!(beyond.stiffness > 0)) return;
#pragma omp simd
    for (int l = 0; l < L; ++l) {
      const double more = E[l] > beyond.knee ? E[l] - beyond.knee : 0;
      energy[l] += 0.5 * beyond.stiffness * more * more;
      stress[l] += beyond.stiffness * more;
      tangent[l] += more > 0 ? beyond.stiffness : 0;
    }
  }
};

template <int D, int L, int N, bool seam>
void add_energy(const Strain<D, N, seam>& e, const double* X, const Loss& loss, double* W) {
  alignas(64) double E[L];
  Legs<D, L, N>(e, X).strain(e, E);
  const Response<L> response(e, loss, E);
#pragma omp simd
  for (int l = 0; l < L; ++l) W[l] += response.energy[l];
}

template <int D, int L, int N, bool seam>
void add_force(const Strain<D, N, seam>& e, const double* X, const Loss& loss, double* F) {
  alignas(64) double E[L];
  const Legs<D, L, N> legs(e, X);
  legs.strain(e, E);
  const Response<L> response(e, loss, E);
  for (int k = 0; k < N; ++k) {
    double* a = F + e.leg[k][0] * D * L;
    double* b = F + e.leg[k][1] * D * L;
    const double factor = 2 * e.weight[k];
    for (int c = 0; c < D; ++c) {
#pragma omp simd
      for (int l = 0; l < L; ++l) {
        const double pull = factor * response.stress[l] * legs.d[k][c][l];
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

/// Calls visit(strain, loss) for the membrane strains, with the loss of each, and leaves `loss` as
/// that of the strain beyond them.
template <int L, int D, bool seam, class Visit>
void for_strains(const Elements<D, seam>& elements, Loss& loss, const Visit& visit) {
  const auto over = [&](const auto& strains) {
    for (const auto& e : strains) visit(e, loss), loss.next<L>();
  };
  over(elements.edges);
  over(elements.shears);
  over(elements.dilations);
}

template <int L, int D, class Visit>
void for_strains(const Sheet<D>& sheet, Loss loss, const Visit& visit) {
  for_strains<L>(sheet.inner, loss, visit);
  for_strains<L>(sheet.seam, loss, visit);
}

/// Adds the elastic energy of each lane to W[lane].
template <int D, int L>
void add_energy(const Sheet<D>& sheet, const double* X, double* W, const Loss& loss = {}) {
  for_strains<L>(sheet, loss,
                 [&](const auto& e, const Loss& own) { add_energy<D, L>(e, X, own, W); });
  for (const auto& e : sheet.inner.bends) add_energy<D, L>(e, X, W);
  for (const auto& e : sheet.seam.bends) add_energy<D, L>(e, X, W);
}

/// Adds -dW/dX of each lane to F.
template <int D, int L>
void add_force(const Sheet<D>& sheet, const double* X, double* F, const Loss& loss = {}) {
  for_strains<L>(sheet, loss,
                 [&](const auto& e, const Loss& own) { add_force<D, L>(e, X, own, F); });
  for (const auto& e : sheet.inner.bends) add_force<D, L>(e, X, F);
  for (const auto& e : sheet.seam.bends) add_force<D, L>(e, X, F);
}

/// On return past[strain][lane] = share times each membrane strain at X.
template <int D, int L>
void find_past(const Sheet<D>& sheet, const double* X, double share, double* past) {
  for_strains<L>(sheet, {1, past}, [&]<int N, bool seam>(const Strain<D, N, seam>& e, const Loss&) {
    Legs<D, L, N>(e, X).strain(e, past);
    for (int l = 0; l < L; ++l) past[l] *= share;
    past += L;
  });
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
