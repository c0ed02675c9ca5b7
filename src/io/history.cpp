#include "io/history.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <cmath>
#include <fstream>

#include "base/error.hpp"
#include "io/file.hpp"

namespace washtub {
namespace {

std::string header(const std::vector<Column>& columns) {
  std::string line;
  for (const Column& c : columns) {
    if (!line.empty()) line += ',';
    line += c.unit.empty() ? c.name : fmt::format("{} [{}]", c.name, c.unit);
  }
  return line;
}

/// The file's header and first `rows` rows, without an unfinished last one; `rows` becomes how many
/// there are.
std::string kept(const std::string& path, const std::string& expected, long& rows) {
  std::ifstream file(path);
  std::string line, text = expected + '\n';
  if (!file) throw RunError(fmt::format("cannot read {}", path));
  if (!std::getline(file, line) || line != expected)
    throw RunError(
        fmt::format("{}: header is \"{}\", expected \"{}\": the file is of another run or "
                    "version; try a new output directory",
                    path, line, expected));
  long found = 0;
  for (; found < rows && std::getline(file, line) && !file.eof(); ++found) text += line + '\n';
  rows = found;
  return text;
}

}  // namespace

History::History(const std::string& path, const std::vector<Column>& columns)
    : path_(path), columns_(columns.size()) {
  open(O_WRONLY | O_CREAT | O_TRUNC);
  append(header(columns) + '\n');
}

History::History(const std::string& path, const std::vector<Column>& columns, long rows)
    : path_(path), columns_(columns.size()), rows_(rows) {
  replace_file(path, kept(path, header(columns), rows_));
  open(O_WRONLY | O_APPEND);
}

History::Descriptor::~Descriptor() {
  if (id >= 0) ::close(id);
}

void History::open(int flags) {
  file_.id = ::open(path_.c_str(), flags | O_CLOEXEC, 0666);
  if (file_.id < 0) throw RunError(cannot_write(path_, errno));
}

/// Rows written to a file without a name would be lost without a word.
void History::check_in_place() const {
  struct ::stat opened, named;
  if (::fstat(file_.id, &opened) != 0) throw RunError(cannot_write(path_, errno));
  if (::stat(path_.c_str(), &named) != 0 || named.st_ino != opened.st_ino ||
      named.st_dev != opened.st_dev)
    throw RunError(
        fmt::format("cannot write {}: it was removed or replaced while the run went on", path_));
}

void History::append(const std::string& line) {
  check_in_place();
  const ::off_t before = ::lseek(file_.id, 0, SEEK_END);
  for (std::size_t done = 0; done < line.size();) {
    const ::ssize_t written = ::write(file_.id, line.data() + done, line.size() - done);
    if (written < 0) {
      const std::string text = cannot_write(path_, errno);
      if (done > 0 && ::ftruncate(file_.id, before) != 0)
        throw RunError(text + " (an incomplete row remains at its end)");
      throw RunError(text);
    }
    done += static_cast<std::size_t>(written);
  }
}

void History::sync() const {
  if (::fsync(file_.id) != 0) throw RunError(cannot_write(path_, errno));
}

void History::add(std::span<const double> row) {
  if (row.size() != columns_)
    throw RunError(fmt::format("{}: {} values for {} columns", path_, row.size(), columns_));
  std::string line;
  for (const double value : row) {
    const bool exact = line.empty();  // intervals are differences of times
    if (std::isfinite(value))
      line += exact ? fmt::format("{}", value) : fmt::format("{:.9g}", value);
    line += ',';
  }
  line.back() = '\n';
  append(line);
  ++rows_;
}

}  // namespace washtub
