#pragma once
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <string>
#include <utility>
#include <vector>

#include "base/table.hpp"

namespace washtub {

/// A table whose key `kind` decides which other keys it has; T has a member `kind`, the text.
template <class T>
class Kinds {
 public:
  Kinds& kind(const std::string& name, Table<T> table) {
    kinds_.emplace_back(name, std::move(table));
    return *this;
  }

  /// Reads and writes the table in one line.
  Format<T> format() const {
    auto read = [self = *this](const Node& node, int dimension) {
      return self.read(node, dimension);
    };
    auto write = [self = *this](const T& value, int dimension) {
      const auto lines = self.table(value.kind).lines(value, dimension);
      const char* gap = lines.empty() ? "" : ", ";
      return fmt::format("{{ kind = \"{}\"{}{} }}", value.kind, gap, fmt::join(lines, ", "));
    };
    return {read, write, "table", fmt::format("`kind` one of {}", fmt::join(names(), ", "))};
  }

  T read(const Node& node, int dimension) const {
    if (!node.is_table())
      throw error_at(node, "expected a table such as { kind = \"" + kinds_.front().first + "\" }");
    const Node* kind = node.find("kind");
    if (!kind)
      throw error_at(node, fmt::format("missing key kind: one of {}", fmt::join(names(), ", ")));
    T value;
    value.kind = kinds_[static_cast<size_t>(name_of(names()).read(*kind, dimension))].first;
    check_known(node, known(node, table(value.kind)));
    table(value.kind).read(value, node, dimension);
    return value;
  }

  void document(std::string& out, const std::string& path) const {
    for (const auto& [name, table] : kinds_) table.document(out, path + " " + name);
  }

 private:
  std::vector<std::string> names() const {
    std::vector<std::string> result;
    for (const auto& [name, table] : kinds_) result.push_back(name);
    return result;
  }
  const Table<T>& table(const std::string& kind) const {
    size_t i = 0;
    while (kinds_[i].first != kind) ++i;
    return kinds_[i].second;
  }
  static std::vector<std::string> known(const Node& node, const Table<T>& table) {
    const std::string path = plain_key(node.key);
    std::vector<std::string> result{path + ".kind"};
    for (const std::string& name : table.names()) result.push_back(path + "." + name);
    return result;
  }

  std::vector<std::pair<std::string, Table<T>>> kinds_;
};

}  // namespace washtub
