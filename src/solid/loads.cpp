#include "solid/loads.hpp"

#include <cstring>

namespace washtub {
namespace {

/// Adds up the loads on one solid, row by row.
template <int D>
class LoadSum {
 public:
  LoadSum(const Grid<D>& grid, const DomainMapping<D>& mapping, std::size_t solid,
          const WaterState<D>& water)
      : grid_(grid),
        mapping_(mapping),
        solid_(solid),
        water_(water),
        open_(mapping.open()),
        centre_(mapping.solids()[solid].centre),
        marks_(static_cast<std::size_t>(grid.block().width()) + 16) {}

  SurfaceLoads<D> run() {
    const auto& box = mapping_.reach(solid_);
    if (box.empty()) return loads_;
    const int j0 = D == 3 ? box.lower[1] : 0, j1 = D == 3 ? box.upper[1] : 1;
    for (int k = box.lower[D - 1]; k < box.upper[D - 1]; ++k)
      for (int j = j0; j < j1; ++j)
        for (int c = 0; c < D; ++c) {
          for (int d = 0; d < D; ++d) add_fluxes(row(c, j, k), c, d, j, k);
          add_body(row(c, j, k), c, j, k);
        }
    return loads_;
  }

 private:
  /// A row of faces normal to one axis.
  struct Row {
    long p;
    int begin, end;
    Vec<D> start;  ///< position of face 0 relative to the solid's centre [m]
  };

  Row row(int c, int j, int k) const {
    const auto& box = mapping_.reach(solid_);
    Index<D> cell{};
    if constexpr (D == 3) cell[1] = j;
    cell[D - 1] = k;
    Row r{grid_.block().row(j, k), box.lower[0], box.upper[0], grid_.position(cell, c)};
    for (int d = 0; d < 2; ++d) r.start[d] -= centre_[d];
    return r;
  }

  /// A force along `axis` at face i, `shift` away from its centre. The moment of F along x is -y F,
  /// of F along y it is x F.
  void add(Load<D>& load, const Row& r, int axis, int i, const Vec<D>& shift, double force) const {
    load.force[axis] += force;
    if (axis == 0) load.torque -= (r.start[1] + shift[1]) * force;
    if (axis == 1) load.torque += (r.start[0] + shift[0] + i * grid_.mesh().h[0]) * force;
  }

  /// Visits the marked faces of a row, in steps of eight where there are none.
  template <class Visit>
  void for_marks(const Row& r, Visit&& visit) const {
    for (int i = r.begin; i < r.end;) {
      std::uint64_t eight;
      std::memcpy(&eight, marks_.data() + i, sizeof eight);
      if (eight == 0) {
        i += 8;
        continue;
      }
      if (marks_[static_cast<std::size_t>(i)] != 0) visit(i);
      ++i;
    }
  }

  bool trim(Row& r, int c, int d, int j, int k) const;
  void add_fluxes(Row r, int c, int d, int j, int k);
  void add_body(Row r, int d, int j, int k);

  const Grid<D>& grid_;
  const DomainMapping<D>& mapping_;
  std::size_t solid_;
  const WaterState<D>& water_;
  std::array<const float*, D> open_;
  Vec<3> centre_;
  std::vector<signed char> marks_;
  SurfaceLoads<D> loads_;
};

/// Leaves out the edges that lie on a side of the box; false if that is the whole row.
template <int D>
bool LoadSum<D>::trim(Row& r, int c, int d, int j, int k) const {
  if (d == 0) {
    if (grid_.at_side(0, 1)) r.end = std::min(r.end, grid_.block().width() - 1);
    if (c == 0 && grid_.at_side(0, 0)) r.begin = std::max(r.begin, 1);
    return true;
  }
  const int at = d == D - 1 ? k : j;
  const bool on_upper = at == grid_.block().count[d] - 1 && grid_.at_side(d, 1);
  const bool on_lower = c == d && at == 0 && grid_.at_side(d, 0);
  return !on_upper && !on_lower;
}

/// Fluxes of momentum component c along d through the edges where the surface lies.
template <int D>
void LoadSum<D>::add_fluxes(Row r, int c, int d, int j, int k) {
  if (!trim(r, c, d, j, k)) return;
  const auto& block = grid_.block();
  const auto& h = grid_.mesh().h;
  const long s = d == 0 ? 1 : block.stride[d], t = c == 0 ? 1 : block.stride[c];
  const float* phi = open_[c] + r.p;
  signed char* mark = marks_.data();
  int any = 0;
#pragma omp simd reduction(| : any)
  for (int i = r.begin; i < r.end; ++i) {  // +1 where the solid lies above the edge, -1 where below
    const int side = (phi[i] >= 1) - (phi[i + s] >= 1);
    mark[i] = static_cast<signed char>(side);
    any |= side;
  }
  if (any == 0) return;
  std::fill_n(mark + r.end, 8, static_cast<signed char>(0));
  const std::uint8_t* owner = mapping_.owner(c) + r.p;
  const double* u = water_.velocity[c] + r.p;
  const double* w = water_.velocity[d] + r.p + s;  // faces along d on the edge between both cells
  const double area = grid_.mesh().cell_volume() / h[d];
  Vec<D> shift = Vec<D>::Zero();
  shift[d] = 0.5 * h[d];
  for_marks(r, [&](int i) {
    if ((phi[i] < phi[i + s] ? owner[i] : owner[i + s]) != solid_) return;
    const double side = area * mark[i];
    const double strain = (u[i] - u[i + s]) / h[d] + (w[i - t] - w[i]) / h[c];
    const double carried = 0.25 * (w[i - t] + w[i]) * (u[i] + u[i + s]);
    add(loads_.friction, r, c, i, shift, side * water_.viscosity * strain);
    add(loads_.convection, r, c, i, shift, side * water_.density * carried);
  });
}

/// Pressure on the closed faces normal to d, and the cloth force that was spread to them.
template <int D>
void LoadSum<D>::add_body(Row r, int d, int j, int k) {
  if (d == 0 && grid_.at_side(0, 0)) r.begin = std::max(r.begin, 1);
  if (d > 0 && (d == D - 1 ? k : j) == 0 && grid_.at_side(d, 0)) return;
  const long s = d == 0 ? 1 : grid_.block().stride[d];
  const float* phi = open_[d] + r.p;
  signed char* mark = marks_.data();
#pragma omp simd
  for (int i = r.begin; i < r.end; ++i) mark[i] = phi[i] < 1 ? 1 : 0;
  std::fill_n(mark + r.end, 8, static_cast<signed char>(0));
  const std::uint8_t* owner = mapping_.owner(d) + r.p;
  const double* p = water_.pressure + r.p;
  const double* f = water_.force[d] + r.p;
  const double volume = grid_.mesh().cell_volume();
  const double area = volume / grid_.mesh().h[d];
  for_marks(r, [&](int i) {
    if (owner[i] != solid_) return;
    add(loads_.pressure, r, d, i, Vec<D>::Zero(), area * (p[i - s] - p[i]));
    add(loads_.cloth, r, d, i, Vec<D>::Zero(), volume * f[i]);
  });
}

}  // namespace

template <int D>
SurfaceLoads<D> surface_loads(const Grid<D>& grid, const DomainMapping<D>& mapping,
                              std::size_t solid, const WaterState<D>& water) {
  return LoadSum<D>(grid, mapping, solid, water).run();
}

template SurfaceLoads<2> surface_loads<2>(const Grid<2>&, const DomainMapping<2>&, std::size_t,
                                          const WaterState<2>&);
template SurfaceLoads<3> surface_loads<3>(const Grid<3>&, const DomainMapping<3>&, std::size_t,
                                          const WaterState<3>&);

}  // namespace washtub
