#pragma once

namespace washtub {

/// How the faces at a surface close: what stands for H(psi) of Eq. (9).
struct Heaviside {
  enum class Kind {
    sharp,    ///< a face is closed where its centre is in the solid
    smooth,   ///< Eq. (11): closing over 2 gamma across the surface, water held to the solid
    gradual,  ///< opening over one cell in front of the surface, water held to a linear profile
  };
  Kind kind = Kind::sharp;
  double gamma = 0;  ///< half width of the smooth one [m]
  double shift = 0;  ///< how far outside the surface the sharp one still closes a face, over
                     ///< sum_d |n_d| h_d, the width of a cell along the normal

  static Heaviside sharp(double shift = 0) { return {Kind::sharp, 0, shift}; }
  static Heaviside smooth(double gamma) { return {Kind::smooth, gamma, 0}; }
  static Heaviside gradual() { return {Kind::gradual, 0, 0}; }

  /// 1 - H(psi), Eq. (11); a face centre on the surface is in the water. Faces that are open by
  /// less than a thousandth are closed.
  float open_fraction(double psi) const;
};

}  // namespace washtub
