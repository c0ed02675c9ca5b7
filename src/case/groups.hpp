#pragma once
#include <optional>
#include <string>
#include <vector>

#include "case/case.hpp"

namespace washtub {

/// What the scales of a case, Eq. (17), make of stresses and torques.
struct Scales {
  double stress;  ///< sigma_o = rho_f r_o^2 omega_max^2 [Pa]
  double torque;  ///< tau_o = sigma_o r_o^2 H [N m], per metre in 2-D
};

/// None where nothing gives the case a speed.
std::optional<Scales> scales(const Case& whole);

/// A dimensionless group.
struct Group {
  std::string name;  ///< "Re"
  double value = 0;
  std::string meaning;  ///< its formula in words
};

/// Groups of Eqs. (18) and (19), and the Reynolds number of a cell. Those of cloth are given once
/// where all cloth of the case has them alike, else for every group: "Te of towels". None without
/// scales.
std::vector<Group> groups(const Case& whole);

}  // namespace washtub
