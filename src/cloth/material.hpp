#pragma once
#include <limits>

namespace washtub {

/// Elastic constants of a sheet. An isotropic one of modulus E has the values of Eq. (14); the
/// paper's cloth does not, so each constant is given on its own, and `poisson` enters only the
/// cross terms between the two directions of the sheet.
struct Material {
  double stretch = 0;         ///< K_e, E q/(1 - nu^2) if isotropic [N/m]
  double shear = 0;           ///< K_s, E q/(1 + nu) if isotropic [N/m]; plates only
  double bending = 0;         ///< K_b, E q^3/(12 (1 - nu^2)) if isotropic [N m]
  double torsion = 0;         ///< K_t, E q^3/(12 (1 + nu)) if isotropic [N m]; plates only
  double poisson = 0;         ///< nu, from 0 to below 1; plates only
  double excess_mass = 0;     ///< rho_s q, beyond the displaced water [kg/m^2]
  double thickness = 0;       ///< q [m]
  double friction = 0;        ///< coefficient against other cloth of its kind
  double solid_friction = 0;  ///< against solids and sides of the box
  /// tau of Kelvin's and Voigt's law: membrane stress is K (E + tau dE/dt) [s]. Implicit solve
  /// only.
  double loss_time = 0;
  double permeability = 0;    ///< lambda, velocity through the cloth by pressure [m/(s Pa)]
  double stretch_beyond = 0;  ///< K_e of strains beyond `knee` [N/m]
  double knee = std::numeric_limits<double>::infinity();

  /// The strain of Eq. (12) at which K_e alone would have the stress that the cloth has at `e`. The
  /// knee is one of Green's strain e/(1 - 2 e).
  double effective(double e) const {
    const double green = e / (1 - 2 * e);
    return green > knee ? e + (stretch_beyond / stretch - 1) * (green - knee) * (1 - 2 * e) : e;
  }
};

}  // namespace washtub
