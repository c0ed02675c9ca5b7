#include "coupling/immersed_boundary.hpp"

#include <algorithm>
#include <type_traits>

namespace washtub {
namespace {

constexpr double mobility_floor = 0.02;  // of that of a single cell

/// Neighbouring values of a row, side by side in a vector register.
using Lane = Eigen::Array<double, kernel_points, 1>;
using Weights = std::array<double, kernel_points>;

/// Calls work() with the number of points as a constant.
template <class Work>
void with_points(int points, Work&& work) {
  if (points == 3)
    work(std::integral_constant<int, 3>());
  else
    work(std::integral_constant<int, kernel_points>());
}

/// How one component meets the delta function of a marker.
template <int D>
struct Stencil {
  const typename Stencils<D>::Place& place;
  int component;
  int width;  ///< of a row

  int on_faces(int axis) const { return axis == component ? 1 : 0; }
  long start() const { return place.start[on_faces(0)]; }
  /// Whether its rows go on at their own beginning.
  bool wraps() const { return start() + kernel_points > width; }
  const std::array<long, kernel_points>& offset(int axis) const {
    return place.offset[axis - 1][on_faces(axis)];
  }
  const Weights& weight(const typename Stencils<D>::WeightsOfAxes& w, int axis) const {
    return w[axis][on_faces(axis)];
  }
};

/// Calls visit(memory position at x = 0, l, m) for all rows: lines l of the last axis and, in 3-D,
/// m of the one before.
template <int Points, int D, class Visit>
void for_rows(const Stencil<D>& s, Visit&& visit) {
  for (int l = 0; l < Points; ++l)
    if constexpr (D == 2)
      visit(s.offset(1)[l], l, 0);
    else
      for (int m = 0; m < Points; ++m) visit(s.offset(2)[l] + s.offset(1)[m], l, m);
}

/// Calls visit(memory position, which) with the places of a row one by one.
template <int D, class Visit>
void for_wrapped(const Stencil<D>& s, long row, Visit&& visit) {
  for (int i = 0; i < kernel_points; ++i) visit(row + (s.start() + i) % s.width, i);
}

/// Sum of weight times value(line). Inlined by force: as a call for each line it takes twice as
/// long.
template <int Points, class Value>
[[gnu::always_inline]] inline Lane weigh(const Weights& weight, Value&& value) {
  Lane sum = weight[0] * value(0);
  for (int l = 1; l < Points; ++l) sum += weight[l] * value(l);
  return sum;
}

/// Sum over the rows of weight times value(memory position at x = 0), a Lane.
template <int Points, int D, class Value>
[[gnu::always_inline]] inline Lane weigh_rows(const Stencil<D>& s,
                                              const typename Stencils<D>::WeightsOfAxes& w,
                                              Value&& value) {
  return weigh<Points>(s.weight(w, D - 1), [&](int l) -> Lane {
    const long plane = s.offset(D - 1)[l];
    if constexpr (D == 2) return value(plane);
    return weigh<Points>(s.weight(w, 1),
                         [&](int m) -> Lane { return value(plane + s.offset(1)[m]); });
  });
}

/// Value of a component at a marker, with value(memory position).
template <int Points, int D, class Value>
double sum(const Stencil<D>& s, const typename Stencils<D>::WeightsOfAxes& w, Value&& value) {
  Lane rows;
  if (!s.wraps())
    rows = weigh_rows<Points>(s, w, [&](long row) {
      Lane v;
      for (int i = 0; i < kernel_points; ++i) v[i] = value(row + s.start() + i);
      return v;
    });
  else
    rows = weigh_rows<Points>(s, w, [&](long row) {
      Lane v;
      for_wrapped(s, row, [&](long p, int i) { v[i] = value(p); });
      return v;
    });
  return (rows * Eigen::Map<const Lane>(s.weight(w, 0).data())).sum();
}

/// Adds weights times `amount` to a field.
template <int Points, int D>
void add(const Stencil<D>& s, const typename Stencils<D>::WeightsOfAxes& w, double amount,
         double* field) {
  const Lane along = amount * Eigen::Map<const Lane>(s.weight(w, 0).data());
  std::array<Weights, Points> weight{};
  for (int l = 0; l < Points; ++l)
    for (int m = 0; m < kernel_points; ++m)
      weight[l][m] = D == 3 ? s.weight(w, 2)[l] * s.weight(w, 1)[m] : s.weight(w, 1)[l];
  if (!s.wraps())
    for_rows<Points>(s, [&](long row, int l, int m) {
      Eigen::Map<Lane>(field + row + s.start()) += weight[l][m] * along;
    });
  else
    for_rows<Points>(s, [&](long row, int l, int m) {
      for_wrapped(s, row, [&](long p, int i) { field[p] += weight[l][m] * along[i]; });
    });
}

}  // namespace

template <int D>
ImmersedBoundary<D>::ImmersedBoundary(const Grid<D>& grid, const Cloth<D>& cloth, Kernel kernel,
                                      const SidePairs<D>& sides, double marker_spacing)
    : grid_(grid),
      stencils_(grid, cloth, kernel, sides, marker_spacing),
      unit_(cloth.position.size(), Vec<D>::Ones()) {
  for (auto& o : ones_) o = grid.make_field();
}

template <int D>
void ImmersedBoundary<D>::spread(const std::vector<Vec<D>>& G, Components<D>& f) const {
  const double per_volume = 1 / grid_.mesh().cell_volume();
  const auto& markers = stencils_.markers();
  const int width = grid_.block().width();
  with_points(stencils_.points(), [&](auto points) {
    for (std::size_t i = 0; i < stencils_.local().size(); ++i) {
      const int m = stencils_.local()[i];
      Vec<D> force = Vec<D>::Zero();
      for (int c = 0; c < Markers<D>::corners; ++c)
        force += markers.share(m)[c] * G[markers.nodes(m)[c]];
      force *= per_volume;
      for (int c = 0; c < D; ++c)
        add<points(), D>({stencils_.places()[i], c, width}, stencils_.weights()[i], force[c],
                         f[c].data());
    }
  });
}

/// U_i = sum over its markers of share times component(c)(memory position).
template <int D>
template <class Component>
void ImmersedBoundary<D>::gather(Component&& component, std::vector<Vec<D>>& U) const {
  const auto& markers = stencils_.markers();
  std::fill(U.begin(), U.end(), Vec<D>::Zero());
  const int width = grid_.block().width();
  with_points(stencils_.points(), [&](auto points) {
    for (std::size_t i = 0; i < stencils_.local().size(); ++i) {
      const int m = stencils_.local()[i];
      Vec<D> u;
      for (int c = 0; c < D; ++c)
        u[c] = sum<points(), D>({stencils_.places()[i], c, width}, stencils_.weights()[i],
                                component(c));
      for (int c = 0; c < Markers<D>::corners; ++c)
        U[markers.nodes(m)[c]] += markers.share(m)[c] * u;
    }
  });
  grid_.parallel().sum(std::span<double>(U.front().data(), U.size() * D));
}

template <int D>
void ImmersedBoundary<D>::interpolate(const Components<D>& u, std::vector<Vec<D>>& U) const {
  gather([&](int c) { return [field = u[c].data()](long p) { return field[p]; }; }, U);
  add_given(U);
}

template <int D>
void ImmersedBoundary<D>::interpolate(const ProvisionalVelocity<D>& u,
                                      std::vector<Vec<D>>& U) const {
  gather([&](int c) { return u.component(c); }, U);
  add_given(U);
}

/// What moving sides add.
template <int D>
void ImmersedBoundary<D>::add_given(std::vector<Vec<D>>& U) const {
  const auto& markers = stencils_.markers();
  for (const auto& [m, given] : stencils_.given())
    for (int c = 0; c < Markers<D>::corners; ++c)
      U[markers.nodes(m)[c]] += markers.share(m)[c] * given;
}

template <int D>
void ImmersedBoundary<D>::mobility(const Openings<D>& openings, double density,
                                   std::vector<Vec<D>>& mobility) {
  for (auto& o : ones_) o.fill(0);
  spread(unit_, ones_);
  gather(
      [&](int c) {
        return
            [one = ones_[c].data(), open = openings.open[c]](long p) { return one[p] * open[p]; };
      },
      mobility);
  const double floor = mobility_floor / (density * grid_.mesh().cell_volume());
  for (auto& d : mobility) d = (d / density).cwiseMax(floor);
}

template class ImmersedBoundary<2>;
template class ImmersedBoundary<3>;

}  // namespace washtub
