#pragma once
#include <span>
#include <string>
#include <vector>

namespace washtub {

/// A column of history.csv.
struct Column {
  std::string name;
  std::string unit;  ///< empty for a pure number
};

/// history.csv: a header with units, "time [s],torque [N m]", then one row per sample, on disk as
/// soon as it is added. To be owned by one rank.
class History {
 public:
  /// Starts a new file, in place of an older one.
  /// @throws RunError with path and reason
  History(const std::string& path, const std::vector<Column>& columns);
  /// Goes on with the file of an interrupted run behind its first `rows` rows; what follows them is
  /// dropped. Fewer may be left of them.
  /// @throws RunError if it cannot be read or its header is another
  History(const std::string& path, const std::vector<Column>& columns, long rows);

  long rows() const { return rows_; }
  /// Waits until all rows are on the disk.
  void sync() const;

  /// One value per column, the first with all its digits, the others with nine; what is not finite
  /// leaves the field empty.
  /// @throws RunError with path and reason; then no part of the row is in the file
  void add(std::span<const double> row);

 private:
  /// An open file, closed at the end of its life.
  struct Descriptor {
    Descriptor() = default;
    ~Descriptor();
    Descriptor(const Descriptor&) = delete;
    Descriptor& operator=(const Descriptor&) = delete;
    int id = -1;
  };
  void open(int flags);
  void check_in_place() const;
  void append(const std::string& line);

  std::string path_;
  std::size_t columns_;
  long rows_ = 0;
  Descriptor file_;
};

}  // namespace washtub
