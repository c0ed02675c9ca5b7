#pragma once
#include <string>
#include <string_view>

namespace washtub {

/// A physical kind of quantity: what an error calls it, its SI unit, an example of it.
struct Measure {
  const char* name;
  const char* unit;
  const char* example;
};

namespace measure {
inline constexpr Measure length{"length", "m", "15 cm"};
inline constexpr Measure time{"time", "s", "0.5 s"};
inline constexpr Measure speed{"speed", "m/s", "0.2 m/s"};
inline constexpr Measure angle{"angle", "rad", "4 deg"};
inline constexpr Measure angular_speed{"angular speed", "rad/s", "120 rpm"};
inline constexpr Measure frequency{"frequency", "Hz", "0.6 Hz"};
inline constexpr Measure density{"density", "kg/m^3", "1000 kg/m^3"};
inline constexpr Measure viscosity{"dynamic viscosity", "Pa s", "1 Pa s"};
inline constexpr Measure stiffness{"force per length", "N/m", "8e5 N/m"};
inline constexpr Measure bending{"bending stiffness", "N m", "1e-5 N m"};
inline constexpr Measure acceleration{"acceleration", "m/s^2", "9.81 m/s^2"};
inline constexpr Measure curvature{"curvature", "m^-1", "4 m^-1"};
inline constexpr Measure pressure{"pressure", "Pa", "4 kPa"};
inline constexpr Measure permeability{"speed per pressure", "m/(s Pa)", "2.7e-5 m/(s Pa)"};
inline constexpr Measure areal_mass{"mass per area", "kg/m^2", "9.3e-2 kg/m^2"};
}  // namespace measure

/// What no quantity of a case exceeds: products of several remain finite.
constexpr double largest_quantity = 1e30;

/// The SI value of a text such as "120 rpm".
/// Angles count as a dimension of their own, so "2 Hz" is no angular speed.
/// @throws InputError `expected force per length such as "8e5 N/m"`, and `unknown unit "blob"` or
/// `expected length up to 1e+30 m` where that is what is wrong
double parse_quantity(std::string_view text, const Measure& expected);

/// "0.31 m": the shortest text that parses to the same value; zero is never "-0".
std::string quantity_text(double value, const Measure& measure);

/// The shortest text of a number, readable by TOML as a float.
std::string number_text(double value);

}  // namespace washtub
