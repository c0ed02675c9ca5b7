#pragma once
#include <string>

namespace washtub {

/// Unit of an output. What a plane case has per metre of its depth is so in all of its files.
struct Unit {
  const char* name = "";  ///< "" for a pure number
  bool per_depth = false;

  /// "N m", "N m/m" in 2-D.
  std::string in(int dimension) const {
    return std::string(name) + (per_depth && dimension == 2 ? "/m" : "");
  }
};

inline constexpr Unit pure_number{};
inline constexpr Unit metre{"m"};
inline constexpr Unit second{"s"};
inline constexpr Unit metre_per_second{"m/s"};
inline constexpr Unit per_second{"1/s"};
inline constexpr Unit pascal{"Pa"};
inline constexpr Unit newton{"N", true};
inline constexpr Unit newton_metre{"N m", true};
inline constexpr Unit joule{"J", true};
inline constexpr Unit watt{"W", true};

/// By which of a case's scales an output is divided.
enum class Scale { none, stress, torque, length, height };

/// Where an output is there.
enum class When { always, moving, space };

/// What an output is. Header, rows, documents and pages take it from here.
struct Declared {
  const char* name;
  Unit unit;
  const char* meaning;
  When when = When::always;

  /// Of a solid, or of anything else that does not move.
  bool applies(int dimension, bool moving = false) const {
    return when == When::always || (when == When::space ? dimension == 3 : moving);
  }
};

/// Where a page draws a column over time. Title and axis of a plot are those of its first curve;
/// names of solids follow titles and statistics.
struct Plot {
  const char* fold = "Other";
  const char* title = "";  ///< "Torque on"; "" = the column's name
  const char* axis = "";   ///< name of the vertical axis
  const char* curve = "";  ///< in the legend
  Scale scale = Scale::none;
  bool shown = true;  ///< at first
  bool logarithmic = false;
  bool instants = false;       ///< of a solid at rest, so that a running mean helps
  const char* statistic = "";  ///< whose mean is drawn with the curve
  const char* integral = "";   ///< title of the plot of its integral over each cycle; "": none
  const char* integral_statistic = "";
};

}  // namespace washtub
