#include "app/protect.hpp"

#include <fmt/format.h>

#include <array>
#include <filesystem>
#include <fstream>
#include <string_view>

#include "base/error.hpp"

namespace washtub {
namespace {

namespace fs = std::filesystem;

bool is_page(const std::string& path) {
  constexpr std::string_view mark = "id=\"washtub-data\"";
  std::ifstream file(path, std::ios::binary);
  std::array<char, 1 << 16> part;
  std::string text;
  while (file.read(part.data(), part.size()), file.gcount() > 0) {
    text.append(part.data(), static_cast<std::size_t>(file.gcount()));
    if (text.find(mark) != std::string::npos) return true;
    text.erase(0, text.size() - std::min(text.size(), mark.size()));
  }
  return false;
}

/// Whether the file begins with a box of the type that MP4 files begin with.
bool is_movie(const std::string& path) {
  std::ifstream file(path, std::ios::binary);
  std::array<char, 8> head{};
  file.read(head.data(), head.size());
  return file.gcount() == 8 && std::string_view(head.data() + 4, 4) == "ftyp";
}

/// Whether a mark stands in the first letters of the file.
bool begins_with(const std::string& path, std::string_view mark) {
  std::ifstream file(path, std::ios::binary);
  std::array<char, 64> head{};
  file.read(head.data(), head.size());
  return std::string_view(head.data(), static_cast<std::size_t>(file.gcount())).find(mark) !=
         std::string_view::npos;
}

bool is_modes(const std::string& path) { return begins_with(path, "\"frequencies [Hz]\""); }
bool is_speeds(const std::string& path) { return begins_with(path, "\"washtub bench\""); }

void protect(const std::string& path, bool (*is_ours)(const std::string&), const char* kind) {
  std::error_code error;
  if (!fs::exists(path, error)) return;
  if (fs::is_directory(path, error))
    throw InputError(fmt::format("{}: is a directory; name a file with -o", path));
  if (!fs::is_regular_file(path, error) || !is_ours(path))
    throw InputError(fmt::format("{}: exists and is no {}; name another file with -o", path, kind));
}

}  // namespace

void protect_page(const std::string& path) { protect(path, is_page, "page of washtub"); }

void protect_movie(const std::string& path) { protect(path, is_movie, "MP4 movie"); }

void protect_modes(const std::string& path) { protect(path, is_modes, "file of washtub modes"); }

void protect_speeds(const std::string& path) { protect(path, is_speeds, "file of washtub bench"); }

}  // namespace washtub
