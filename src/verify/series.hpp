#pragma once
#include <array>
#include <string>
#include <vector>

namespace washtub {

/// One column of a history over time, without the rows that leave it empty.
struct Series {
  std::vector<double> times, values;  ///< [s], and the column's unit
};

/// A history.csv: columns by name.
class HistoryFile {
 public:
  /// @throws InputError where it is missing, empty, or a field is no number
  explicit HistoryFile(const std::string& path);

  /// The column `name`, with its unit as the file has it ("speed [m/s]") or without, between two
  /// times, both included.
  /// @throws InputError naming the nearest column
  Series series(const std::string& name, const std::array<double, 2>& window) const;

 private:
  std::size_t find(const std::string& name) const;

  std::string path_;
  std::vector<std::string> names_, headers_;  ///< without and with units
  std::vector<std::vector<double>> columns_;
};

/// A minus b, at the times of a. @throws InputError where they have not the same times
Series difference(const Series& a, const Series& b);

}  // namespace washtub
