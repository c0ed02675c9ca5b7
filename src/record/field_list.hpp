#pragma once
#include <vector>

#include "io/field.hpp"

namespace washtub {

/// What is declared of the fields in the frames, per cell of the water and per node of the cloth.
std::vector<FieldDescription> water_field_list();
std::vector<FieldDescription> cloth_field_list();

}  // namespace washtub
