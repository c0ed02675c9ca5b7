#include "app/directory.hpp"

#include <fmt/format.h>
#include <unistd.h>

#include <filesystem>
#include <system_error>

#include "base/error.hpp"
#include "batch/batch.hpp"

namespace washtub {

namespace fs = std::filesystem;

std::string default_directory(const std::string& case_path) {
  const fs::path path = fs::absolute(case_path).lexically_normal();
  const fs::path name = path.stem() == "case" ? path.parent_path().filename() : path.stem();
  return (fs::path("out") / name).string();
}

void make_results_folder(const std::string& directory) {
  std::error_code error;
  fs::create_directories(directory, error);
  if (error || access(directory.c_str(), W_OK | X_OK) != 0)
    throw InputError(
        fmt::format("{}: cannot be made or written; name another one with -o", directory));
}

void protect_case(const std::string& case_path, const std::string& directory) {
  std::error_code error;
  const fs::path folder = fs::absolute(case_path).parent_path();
  if (fs::equivalent(folder, directory, error) && fs::path(case_path).filename() == "case.toml")
    throw InputError(fmt::format(
        "{}: is the folder of the case file, which a run would overwrite; name another with -o",
        directory));
}

namespace {

/// Everything that is written of a run, but for case.toml, from which it may be about to start.
constexpr const char* results[] = {"history.csv", "tracks.csv",     "summary.json", "log.txt",
                                   "frames.xdmf", "paraview.xdmf2", "frames",       "report.html",
                                   "movie.mp4",   "checkpoints",    finished_mark};

/// Whether there is anything but our lock in the directory.
bool holds_files(const std::string& directory) {
  std::error_code error;
  for (const auto& entry : fs::directory_iterator(directory, error))
    if (entry.path().filename() != DirectoryLock::name) return true;
  return false;
}

void remove_results(const std::string& directory) {
  std::error_code error;
  for (const char* name : results) {
    fs::remove_all(fs::path(directory) / name, error);
    fs::remove(fs::path(directory) / fmt::format("{}.part", name), error);
  }
}

}  // namespace

void remove_unfinished(const std::string& directory) {
  for (const char* folder : {"", "frames", "checkpoints"}) {
    std::error_code error;
    for (const auto& entry : fs::directory_iterator(fs::path(directory) / folder, error))
      if (entry.path().extension() == ".part") fs::remove(entry.path(), error);
  }
}

DirectoryLock prepare_directory(const std::string& directory, bool force) {
  std::error_code error;
  if (fs::exists(directory, error) && !fs::is_directory(directory, error))
    throw InputError(fmt::format("{}: is not a directory; name another one with -o", directory));
  fs::create_directories(directory, error);
  if (error) throw InputError(fmt::format("{}: cannot be made: {}", directory, error.message()));
  if (access(directory.c_str(), W_OK | X_OK) != 0)
    throw InputError(fmt::format("{}: cannot be written; name another one with -o", directory));
  DirectoryLock lock(directory);
  if (!lock.note().empty()) fmt::print(stderr, "washtub: {}\n", lock.note());
  if (!force && holds_files(directory))
    throw InputError(
        fmt::format("{}: holds files already; name another directory with -o, or overwrite results "
                    "with --force",
                    directory));
  remove_results(directory);
  return lock;
}

}  // namespace washtub
