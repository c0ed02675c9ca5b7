#pragma once
#include <string>
#include <utility>
#include <vector>

#include "base/table.hpp"

namespace washtub {

/// What Kawabata's instruments (KES-F) read, in their units.
struct KesReadings {
  double B = 0;    ///< bending rigidity [gf cm^2/cm]
  double G = 0;    ///< shear stiffness [gf/(cm deg)]
  double LT = 0;   ///< linearity of the tensile curve
  double EMT = 0;  ///< extension at 500 gf/cm [%]
};
Table<KesReadings> kes_table();

/// What the instruments of FAST read, in their units.
struct FastReadings {
  double W = 0;    ///< mass [g/m^2]
  double C = 0;    ///< bending length [mm]
  double E5 = 0;   ///< extension at 5 gf/cm [%]
  double E20 = 0;  ///< extension at 20 gf/cm [%]
  double EB5 = 0;  ///< extension on the bias at 5 gf/cm [%]
};
Table<FastReadings> fast_table();

/// Keys of `[[cloth]]` and their values by the readings in its tables `kes` and `fast`.
/// @throws InputError for one that is missing or out of range
std::vector<std::pair<std::string, Node>> read_readings(const Node& cloth, int dimension);

}  // namespace washtub
