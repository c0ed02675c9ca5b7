#include "solid/loads.hpp"

namespace washtub {
namespace {

/// One row of faces normal to `axis` and the lever arms of the forces along that axis.
template <int D>
struct FaceRow {
  long p;
  int begin, end;
  Vec<D> start;  ///< position of face 0 relative to the solid's centre [m]
};

/// Adds forces along `axis` at the row's faces, moved by `shift` from the face centres. The moment
/// of F along x is -y F, of F along y it is x F.
template <int D, class Force>
void add_row(Load<D>& load, const FaceRow<D>& row, int axis, const Vec<D>& shift, double h,
             Force&& force) {
  double sum = 0, moment = 0;
#pragma omp simd reduction(+ : sum, moment)
  for (int i = row.begin; i < row.end; ++i) {
    const double f = force(i);
    sum += f;
    moment += f * i;
  }
  load.force[axis] += sum;
  if (axis == 0) load.torque -= (row.start[1] + shift[1]) * sum;
  if (axis == 1) load.torque += (row.start[0] + shift[0]) * sum + h * moment;
}

}  // namespace

template <int D>
SurfaceLoads<D> surface_loads(const Grid<D>& grid, const DomainMapping<D>& mapping,
                              std::size_t solid, const WaterState<D>& water) {

  SurfaceLoads<D> loads;
  const auto& box = mapping.reach(solid);
  if (box.empty()) return loads;
  const auto& block = grid.block();
  const auto& mesh = grid.mesh();
  const auto open = mapping.open();
  const double volume = mesh.cell_volume();
  const Vec<3>& centre = mapping.solids()[solid].centre;

  const auto row_of_faces = [&](int c, int j, int k) {
    Index<D> cell{};
    if constexpr (D == 3) cell[1] = j;
    cell[D - 1] = k;
    FaceRow<D> row{block.row(j, k), box.lower[0], box.upper[0], grid.position(cell, c)};
    for (int d = 0; d < std::min(D, 2); ++d) row.start[d] -= centre[d];
    return row;
  };
  const auto coordinate = [](int d, int j, int k) { return d == D - 1 ? k : j; };

  const auto add_fluxes = [&](int c, int d, int j, int k) {
    FaceRow<D> row = row_of_faces(c, j, k);
    if (d == 0) {
      if (grid.at_side(0, 1)) row.end = std::min(row.end, block.width() - 1);
      if (c == 0 && grid.at_side(0, 0)) row.begin = std::max(row.begin, 1);
    } else {
      const int at = coordinate(d, j, k);
      if (at == block.count[d] - 1 && grid.at_side(d, 1)) return;
      if (c == d && at == 0 && grid.at_side(d, 0)) return;
    }
    const long s = d == 0 ? 1 : block.stride[d];
    const long t = c == 0 ? 1 : block.stride[c];
    const float* phi = open[c] + row.p;
    const std::uint8_t* owner = mapping.owner(c) + row.p;
    const double* u = water.velocity[c] + row.p;
    const double* w = water.velocity[d] + row.p + s;  // faces along d on the edge between both cells
    const double area = volume / mesh.h[d], mu = water.viscosity * area;
    const double per_d = 1 / mesh.h[d], per_c = 1 / mesh.h[c];
    const double carried = 0.25 * water.density * area;
    Vec<D> shift = Vec<D>::Zero();
    shift[d] = 0.5 * mesh.h[d];
    const auto step = [&](int i) {  // +1 where the solid lies above the edge, -1 where below
      const int side = (phi[i] >= 1) - (phi[i + s] >= 1);
      const bool mine = (phi[i] < phi[i + s] ? owner[i] : owner[i + s]) == solid;
      return mine ? static_cast<double>(side) : 0.0;
    };
    add_row<D>(loads.friction, row, c, shift, mesh.h[0], [&](int i) {
      return step(i) * mu * ((u[i] - u[i + s]) * per_d + (w[i - t] - w[i]) * per_c);
    });
    add_row<D>(loads.convection, row, c, shift, mesh.h[0],
               [&](int i) { return step(i) * carried * (w[i - t] + w[i]) * (u[i] + u[i + s]); });
  };
  const auto add_body = [&](int d, int j, int k) {
    FaceRow<D> row = row_of_faces(d, j, k);
    if (d == 0 && grid.at_side(0, 0)) row.begin = std::max(row.begin, 1);
    if (d > 0 && coordinate(d, j, k) == 0 && grid.at_side(d, 0)) return;
    const long s = d == 0 ? 1 : block.stride[d];
    const float* phi = open[d] + row.p;
    const std::uint8_t* owner = mapping.owner(d) + row.p;
    const double* p = water.pressure + row.p;
    const double* f = water.force[d] + row.p;
    const double area = volume / mesh.h[d];
    add_row<D>(loads.pressure, row, d, Vec<D>::Zero(), mesh.h[0], [&](int i) {
      return owner[i] == solid ? area * (phi[i] < 1) * (p[i - s] - p[i]) : 0.0;
    });
    add_row<D>(loads.cloth, row, d, Vec<D>::Zero(), mesh.h[0], [&](int i) {
      return owner[i] == solid ? volume * (1 - phi[i]) * f[i] : 0.0;
    });
  };

  const int j0 = D == 3 ? box.lower[1] : 0, j1 = D == 3 ? box.upper[1] : 1;
  for (int k = box.lower[D - 1]; k < box.upper[D - 1]; ++k)
    for (int j = j0; j < j1; ++j)
      for (int c = 0; c < D; ++c) {
        for (int d = 0; d < D; ++d) add_fluxes(c, d, j, k);
        add_body(c, j, k);
      }
  return loads;
}

template SurfaceLoads<2> surface_loads<2>(const Grid<2>&, const DomainMapping<2>&, std::size_t,
 const WaterState<2>&);
template SurfaceLoads<3> surface_loads<3>(const Grid<3>&, const DomainMapping<3>&, std::size_t,
 const WaterState<3>&);

}  // namespace washtub
