#include "app/text_table.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace washtub {
namespace {

/// Characters of a UTF-8 text.
std::size_t width(const std::string& text) {
  return static_cast<std::size_t>(
      std::count_if(text.begin(), text.end(), [](char c) { return (c & 0xC0) != 0x80; }));
}

}  // namespace

void print(const std::vector<TextRow>& table) {
  std::vector<std::size_t> widths(table[0].size());
  for (const TextRow& row : table)
    for (std::size_t i = 0; i < row.size(); ++i) widths[i] = std::max(widths[i], width(row[i]));
  for (const TextRow& row : table) {
    std::string line;
    for (std::size_t i = 0; i < row.size(); ++i)
      line += row[i] + std::string(i + 1 < row.size() ? widths[i] + 2 - width(row[i]) : 0, ' ');
    fmt::print("{}\n", line);
  }
}

}  // namespace washtub
