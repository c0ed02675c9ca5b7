#pragma once
#include <vector>

#include "record/field_list.hpp"
#include "record/observer.hpp"

namespace washtub {

/// A field of the water as it is declared: `take` puts its components in the cell at p of the
/// storage to `to`.
template <int D>
struct WaterField {
  FieldDescription field;
  void (*take)(const Simulation<D>& simulation, long p, float* to);
};

/// A field of the cloth, a scalar per node.
template <int D>
struct ClothField {
  FieldDescription field;
  const std::vector<double>& (Observer<D>::*values)() const;
};

/// The declarations of the fields in the frames.
template <int D>
const std::vector<WaterField<D>>& water_fields();
template <int D>
const std::vector<ClothField<D>>& cloth_fields();

}  // namespace washtub
