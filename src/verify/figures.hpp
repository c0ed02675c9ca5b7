#pragma once
#include <string>
#include <vector>

#include "verify/runs.hpp"

namespace washtub {

/// A figure, drawn or not.
struct Drawn {
  std::string svg;   ///< to be put into a page: no XML header, black follows the page's text colour
  std::string note;  ///< why there is none
};

/// The gnuplot script of a figure with its data; "" where no curve has a point yet.
/// Curves of runs that are not finished, and points of such runs, are left out.
/// @throws InputError where a run does not have what a curve asks for
std::string figure_script(const CaseRuns& c, const Figure& figure);

/// Draws every figure of a case into <directory>/<case>/<figure>.svg with gnuplot; the script stays
/// beside it. Where gnuplot is missing the notes say so.
/// @throws RunError where a file cannot be written
std::vector<Drawn> draw_figures(const CaseRuns& c, const std::string& directory);

}  // namespace washtub
