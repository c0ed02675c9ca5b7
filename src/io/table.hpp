#pragma once
#include <string>
#include <vector>

namespace washtub {

/// A CSV file as History writes it: a header with units, "time [s],torque [N m]", and numbers.
class CsvTable {
 public:
  struct Column {
    std::string name, unit;      ///< "torque", "N m"; "" for a pure number
    std::vector<double> values;  ///< NaN where the field is empty
  };

  /// From the text of a file, whose `path` stands in errors. A last line without its end was being
  /// written, or was cut off by a crash: it is left out.
  /// @throws InputError where there is no header, a line has another number of fields, or a field
  /// is no number
  CsvTable(std::string path, const std::string& text);

  const std::string& path() const { return path_; }
  std::size_t rows() const { return columns_.empty() ? 0 : columns_[0].values.size(); }
  const std::vector<Column>& columns() const { return columns_; }
  bool cut() const { return cut_; }  ///< whether a last line was left out

  /// The column with this name, without its unit or with it as the file has it; null where absent.
  const Column* find(const std::string& name) const;
  /// The same. @throws InputError naming the nearest column
  const Column& column(const std::string& name) const;

 private:
  void add(const std::string& line, std::size_t number);

  std::string path_;
  std::vector<Column> columns_;
  bool cut_ = false;
};

/// What is sound in the text of such a file.
struct SoundRows {
  std::string text;               ///< "" where there is no whole header line
  std::size_t damaged = 0;        ///< rows left out: other fields than the header's, or no numbers,
  std::size_t first_damaged = 0;  ///< or no finite number first; line of the first of them
  bool cut = false;               ///< whether a last line without its end was left out
};

SoundRows sound_rows(const std::string& text);

/// @throws InputError where the file cannot be read either
CsvTable read_table(const std::string& path);

}  // namespace washtub
