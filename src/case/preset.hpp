#pragma once
#include <string>

#include "case/case.hpp"
#include "case/parts.hpp"
#include "solid/agitator.hpp"

namespace washtub {

/// The stroke of the paper: 120 rpm at 2/pi Hz, so that a half stroke sweeps one turn.
DriveSpec paper_stroke();

/// The designer's few numbers. Lengths of the agitator that are 0 follow from the tub's; a 2-D
/// washer uses hub_radius and the fins' number, radius and half thickness.
struct WasherSpec {
  double radius = 0;  ///< of the tub, r_o [m]
  double depth = 0;   ///< of the water, H [m]; 1 in 2-D
  DriveSpec stroke = paper_stroke();
  Agitator3d agitator{.fins = 3};
};

Table<WasherSpec> washer_table();

/// Fills in the lengths that the file leaves open.
void complete(WasherSpec& washer, int dimension);

/// Refuses an agitator that does not fit; `root` is the whole file, for the place of the key.
void check_washer(const WasherSpec& washer, const Node& root, int dimension);

/// Box, sides, solids "tub" and "agitator", and scales of a washer whose axis is x = y = 0.
void fill_case(Case& result, const WasherSpec& washer);

/// Pieces of cloth as the washer places them: pages of a book in 3-D, at random in 2-D.
ClothCase default_cloth(const WasherSpec& washer, int dimension);

}  // namespace washtub
