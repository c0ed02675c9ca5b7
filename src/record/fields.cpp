#include "record/fields.hpp"

#include <algorithm>

#include "record/names.hpp"

namespace washtub {
namespace {

/// Between two faces of a cell along an axis.
template <int D>
long step(const Block<D>& block, int axis) {
  return axis == 0 ? 1 : block.stride[axis];
}

template <int D>
void take_velocity(const Simulation<D>& simulation, long p, float* to) {
  std::fill(to, to + 3, 0.F);
  for (int d = 0; d < D; ++d) {
    const double* u = simulation.flow().velocity()[d].data();
    to[d] = static_cast<float>(0.5 * (u[p] + u[p + step(simulation.grid().block(), d)]));
  }
}

template <int D>
void take_pressure(const Simulation<D>& simulation, long p, float* to) {
  *to = static_cast<float>(simulation.flow().pressure().data()[p]);
}

template <int D>
void take_solid(const Simulation<D>& simulation, long p, float* to) {
  const auto open = simulation.mapping().open();
  float most = 0;
  for (int d = 0; d < D; ++d)
    most = std::max({most, open[d][p], open[d][p + step(simulation.grid().block(), d)]});
  *to = 1 - most;
}

template <class Declared>
std::vector<FieldDescription> descriptions(const std::vector<Declared>& declared) {
  std::vector<FieldDescription> list;
  for (const Declared& one : declared) list.push_back(one.field);
  return list;
}

}  // namespace

template <int D>
const std::vector<WaterField<D>>& water_fields() {
  static const std::vector<WaterField<D>> fields = {
      {{names::velocity, "velocity", "m/s", 3, "mean of the faces of the cell"}, take_velocity<D>},
      {{names::pressure_field, "pressure", "Pa", 1, "at the middle of the cell"}, take_pressure<D>},
      {{names::solid, "solid fraction", "", 1,
        "1 less the open share of the cell's most open face: 0 in water, 1 within solids"},
       take_solid<D>},
  };
  return fields;
}

template <int D>
const std::vector<ClothField<D>>& cloth_fields() {
  static const std::vector<ClothField<D>> fields = {
      {{"membrane", "membrane stress", "Pa", 1, "magnitude of the part of stretching and shear"},
       &Observer<D>::membrane},
      {{"bending", "bending stress", "Pa", 1,
        "magnitude of the part of bending and twisting, at the surface"},
       &Observer<D>::bending},
      {{"total", "total stress", "Pa", 1, "the largest at the surfaces (von Mises in 3-D)"},
       &Observer<D>::total},
  };
  return fields;
}

std::vector<FieldDescription> water_field_list() { return descriptions(water_fields<3>()); }
std::vector<FieldDescription> cloth_field_list() { return descriptions(cloth_fields<3>()); }

template const std::vector<WaterField<2>>& water_fields<2>();
template const std::vector<WaterField<3>>& water_fields<3>();
template const std::vector<ClothField<2>>& cloth_fields<2>();
template const std::vector<ClothField<3>>& cloth_fields<3>();

}  // namespace washtub
