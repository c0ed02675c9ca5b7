#pragma once
#include <vector>

#include "case/case.hpp"
#include "solid/solid.hpp"

namespace washtub {

/// The solids as they act in the box: first those of the case in their order, with their axes
/// brought into a periodic box, then the images of those that come into it, or near it, through a
/// periodic side. Solid::body tells which of the case's an image belongs to.
std::vector<Solid> build_solids(const Case& whole);
/// The same with all images that come nearer to the box than `margin` [m].
std::vector<Solid> build_solids(const Case& whole, double margin);

/// Whether a solid acts with its images along an axis of the box: where it is periodic and the
/// solid ends. One that does not must be the same on both sides.
bool has_images(const SolidCase& solid, const Case& whole, int axis);

}  // namespace washtub
