#include "app/movie_tools.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <unistd.h>

#include <cstdlib>
#include <filesystem>
#include <sstream>
#include <vector>

#include "app/launch.hpp"
#include "base/error.hpp"

namespace washtub {

namespace fs = std::filesystem;

namespace {

/// The first of these programs that the PATH has.
/// @throws RunError naming the package
std::string find_program(const std::vector<std::string>& names, const std::string& package) {
  const char* path = std::getenv("PATH");
  for (const std::string& name : names) {
    std::istringstream folders(path ? path : "");
    for (std::string folder; std::getline(folders, folder, ':');) {
      const std::string file = fmt::format("{}/{}", folder, name);
      if (fs::is_regular_file(file) && access(file.c_str(), X_OK) == 0) return file;
    }
  }
  throw RunError(fmt::format("a movie needs {}, which is not on the PATH; install the package {}",
                             fmt::join(names, " or "), package));
}

std::string find_script() {
  const fs::path program = own_program();
  const fs::path installed = program.parent_path().parent_path() / "share/washtub/viewer/movie.mjs";
  const fs::path file = fs::exists(installed) ? installed : WASHTUB_SOURCE "/viewer/movie.mjs";
  if (!fs::exists(file.parent_path() / "node_modules/playwright-core"))
    throw RunError(
        fmt::format("{}: its packages are missing; run npm ci there", file.parent_path().string()));
  return file.string();
}

}  // namespace

MovieTools find_movie_tools() {
  return {find_program({"node"}, "nodejs"),
          find_program({"chromium", "chromium-browser", "google-chrome"}, "chromium"),
          find_program({"ffmpeg"}, "ffmpeg"), find_script()};
}

}  // namespace washtub
