#pragma once
#include <array>
#include <cmath>
#include <string>
#include <vector>

#include "base/archive.hpp"
#include "cloth/crossings.hpp"
#include "contact/neighbours.hpp"
#include "measure/energy_balance.hpp"
#include "washer/resolution.hpp"

namespace washtub {

/// What a run has shown of its own quality.
struct Quality {
  Resolution worst;                   ///< of all rows
  EnergyBalance balance;              ///< over all rows; of closed boxes only
  Crossings crossings;                ///< in the last frame
  long most_crossings = 0;            ///< edges through another piece, most in a frame
  long most_own_crossings = 0;        ///< edges through their own piece, likewise
  double gap = Neighbours::none;      ///< between pieces, the smallest in a frame [m]
  double own_gap = Neighbours::none;  ///< between two parts of a piece, likewise [m]
  /// Of the pairs of nodes of different pieces that are near, the share that is so again a quarter
  /// and a whole period of the drive later; NaN where that is not known.
  std::array<double, 2> still_near{std::nan(""), std::nan("")};
  std::string start;  ///< a sentence on a start that is not as it should be; mostly empty

  /// One sentence or paragraph on each thing that is not as it should be.
  std::vector<std::string> warnings(const Case& whole) const;
  void state(Archive& archive);
};

/// What a row of the history tells of it.
struct QualitySample {
  Resolution resolution;
  double dissipation = 0;  ///< by viscosity, now [W]
  double residual = 0;     ///< power put in and found nowhere since the row before [W]
};

/// Whether no water passes the sides, so that the balance of energy is kept.
bool is_closed(const Case& whole);

}  // namespace washtub
