#pragma once
#include "case/case.hpp"

namespace washtub {

/// The reference wash in space or in the plane, on `cells` cells along every axis, with or without
/// its cloth.
Case reference_wash(int dimension, int cells, bool cloth);

}  // namespace washtub
