#pragma once
#include <array>
#include <string>
#include <vector>

#include "io/table.hpp"

namespace washtub {

/// One column of a history over time, without the rows that leave it empty.
struct Series {
  std::vector<double> times, values;  ///< [s], and the column's unit
};

/// A column over time, between two times of the window, both included; `name` with its unit as the
/// file has it ("speed [m/s]") or without. The first column is the time.
/// @throws InputError naming the nearest column, or where the window's end has no value
Series series(const CsvTable& table, const std::string& name, const std::array<double, 2>& window);

/// A minus b, at the times of a. @throws InputError where they have not the same times
Series difference(const Series& a, const Series& b);

}  // namespace washtub
