#include "solid/loads.hpp"

#include <algorithm>

namespace washtub {
namespace {

/// Adds up the loads on one solid, face by face, along the first `axes` axes.
template <int D>
class LoadSum {
 public:
  LoadSum(const Grid<D>& grid, const DomainMapping<D>& mapping, std::size_t solid,
          const WaterState<D>& water, int axes)
      : grid_(grid), mapping_(mapping), centre_(mapping.solids()[solid].centre), water_(water) {
    for (int c = 0; c < axes; ++c)
      mapping.for_surface(solid, c, [&](const SurfaceFace<D>& face) {
        add_body(face, c);
        if (!at_water(face.p, c)) return;
        for (int d = 0; d < D; ++d) add_fluxes(face, c, d);
      });
  }

  const SurfaceLoads<D>& loads() const { return loads_; }

 private:
  bool at_water(long p, int c) const;
  void add_fluxes(const SurfaceFace<D>& face, int c, int d);
  void add_flux(const SurfaceFace<D>& face, int c, int d, int side);
  void add_body(const SurfaceFace<D>& face, int d);

  const Grid<D>& grid_;
  const DomainMapping<D>& mapping_;
  Vec<3> centre_;
  const WaterState<D>& water_;
  SurfaceLoads<D> loads_;
};

/// Whether some face next to the one at p, along any axis, is fully open.
template <int D>
bool LoadSum<D>::at_water(long p, int c) const {
  const float* open = mapping_.open()[c] + p;
  float most = 0;
  for (const long s : grid_.block().stride) most = std::max({most, open[-s], open[s]});
  return most >= 1;
}

/// Fluxes of momentum component c along d between a face in the solid and its open neighbours.
template <int D>
void LoadSum<D>::add_fluxes(const SurfaceFace<D>& face, int c, int d) {
  const float* open = mapping_.open()[c] + face.p;
  const long s = grid_.block().stride[d];
  if (face.has_edge(d, 0) && open[-s] >= 1) add_flux(face, c, d, 0);
  if (face.has_edge(d, 1) && open[s] >= 1) add_flux(face, c, d, 1);
}

/// The same through the edge on one side (0 lower, 1 upper).
template <int D>
void LoadSum<D>::add_flux(const SurfaceFace<D>& face, int c, int d, int side) {
  const auto& h = grid_.mesh().h;
  const long s = grid_.block().stride[d], t = grid_.block().stride[c];
  const long below = face.p - (side == 0 ? s : 0);
  const double* u = water_.velocity[c] + below;      // below and above the edge
  const double* w = water_.velocity[d] + below + s;  // along d, on both sides of it
  const double strain = (u[0] - u[s]) / h[d] + (w[-t] - w[0]) / h[c];
  const double carried = 0.25 * (w[-t] + w[0]) * (u[0] + u[s]);
  const double area = (side == 0 ? 1 : -1) * grid_.mesh().cell_volume() / h[d];
  Vec<D> x = face.x;
  x[d] += (side - 0.5) * h[d];
  loads_.friction.add(x, centre_, c, area * water_.viscosity * strain);
  loads_.convection.add(x, centre_, c, area * water_.density * carried);
}

/// Pressure on a face normal to d, and the cloth force that was spread to it.
template <int D>
void LoadSum<D>::add_body(const SurfaceFace<D>& face, int d) {
  const double volume = grid_.mesh().cell_volume(), area = volume / grid_.mesh().h[d];
  const double* p = water_.pressure + face.p;
  loads_.pressure.add(face.x, centre_, d, area * (p[-grid_.block().stride[d]] - p[0]));
  loads_.cloth.add(face.x, centre_, d, volume * water_.force[d][face.p]);
}

}  // namespace

template <int D>
SurfaceLoads<D> surface_loads(const Grid<D>& grid, const DomainMapping<D>& mapping,
                              std::size_t solid, const WaterState<D>& water) {
  return LoadSum<D>(grid, mapping, solid, water, D).loads();
}

template <int D>
double surface_torque(const Grid<D>& grid, const DomainMapping<D>& mapping, std::size_t solid,
                      const WaterState<D>& water) {
  return LoadSum<D>(grid, mapping, solid, water, 2).loads().total().torque;
}

template SurfaceLoads<2> surface_loads<2>(const Grid<2>&, const DomainMapping<2>&, std::size_t,
                                          const WaterState<2>&);
template SurfaceLoads<3> surface_loads<3>(const Grid<3>&, const DomainMapping<3>&, std::size_t,
                                          const WaterState<3>&);
template double surface_torque<2>(const Grid<2>&, const DomainMapping<2>&, std::size_t,
                                  const WaterState<2>&);
template double surface_torque<3>(const Grid<3>&, const DomainMapping<3>&, std::size_t,
                                  const WaterState<3>&);

}  // namespace washtub
