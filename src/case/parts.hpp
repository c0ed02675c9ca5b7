#pragma once
#include <limits>
#include <string>
#include <vector>

#include "base/kinds.hpp"
#include "solid/drive.hpp"
#include "solid/shape.hpp"

namespace washtub {

/// A drive as the case file gives it.
struct DriveSpec {
  std::string kind = "rest";
  double speed = 0;            ///< constant [rad/s]
  double peak = 0;             ///< sinusoid [rad/s]
  double frequency = 0;        ///< sinusoid [Hz]
  std::vector<double> times;   ///< table [s]
  std::vector<double> speeds;  ///< table [rad/s]
  bool repeat = true;          ///< table
};
const Kinds<DriveSpec, Drive>& drive_kinds();

/// A shape as the case file gives it; each kind uses some of the members.
struct ShapeSpec {
  std::string kind = "sphere";
  Vec<3> centre = Vec<3>::Zero();
  double radius = 0;
  double z_lower = -unbounded, z_upper = unbounded;  ///< of a cylinder
  Vec<3> lower = Vec<3>::Zero(), upper = Vec<3>::Zero();
  Vec<3> a = Vec<3>::Zero(), b = Vec<3>::Zero();
  Vec<3> point = Vec<3>::Zero(), normal = Vec<3>::UnitX();
  std::vector<Vec<2>> outline;  ///< (r, z) of a revolution, (x, z) of a plate
  double half_thickness = 0;
  double angle = 0;  ///< turned about z [rad], after everything else
  std::vector<ShapeSpec> parts;

  static constexpr double unbounded = std::numeric_limits<double>::infinity();
};
const Kinds<ShapeSpec, Shape>& shape_kinds();

/// A [[solid]] table.
struct SolidSpec {
  std::string name;
  ShapeSpec shape;
  Vec<3> centre = Vec<3>::Zero();
  double angle = 0;  ///< of the shape about z at t = 0 [rad]
  DriveSpec drive;
};
Table<SolidSpec> solid_table();

}  // namespace washtub
