#include "io/lock.hpp"

#include <fcntl.h>
#include <fmt/chrono.h>
#include <fmt/format.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <cstring>
#include <ctime>
#include <fstream>
#include <utility>

#include "base/error.hpp"

namespace washtub {
namespace {

std::string host() {
  std::array<char, 256> name{};
  gethostname(name.data(), name.size() - 1);
  return name.data();
}

/// The first line of the file: who holds it.
std::string holder(const std::string& path) {
  std::string line;
  std::ifstream file(path);
  return std::getline(file, line) && !line.empty() ? line : "a process that has just started";
}

/// Whether the path still names the open file: the run before may have removed it meanwhile.
bool is_at(const std::string& path, int file) {
  struct stat there {
  }, here{};
  return stat(path.c_str(), &there) == 0 && fstat(file, &here) == 0 &&
         there.st_ino == here.st_ino && there.st_dev == here.st_dev;
}

}  // namespace

DirectoryLock::DirectoryLock(const std::string& directory) : path_(directory + '/' + name) {
  while (!try_lock()) {
  }
  sign();
}

/// False where the file was removed between opening and locking it.
bool DirectoryLock::try_lock() {
  file_ = open(path_.c_str(), O_RDWR | O_CREAT, 0666);
  if (file_ < 0)
    throw InputError(fmt::format("{}: cannot be opened: {}; name another directory with -o", path_,
                                 std::strerror(errno)));
  if (flock(file_, LOCK_EX | LOCK_NB) == 0) {
    if (is_at(path_, file_)) return true;
    close(std::exchange(file_, -1));
    return false;
  }
  const int reason = errno;
  if (reason == EWOULDBLOCK) {
    close(std::exchange(file_, -1));
    throw InputError(
        fmt::format("{}: another run writes here: {}; wait for its end, end it with kill, or name "
                    "another directory with -o",
                    path_.substr(0, path_.rfind('/')), holder(path_)));
  }
  note_ = fmt::format("{}: no lock: {}; nothing keeps another run from writing into this directory",
                      path_, std::strerror(reason));
  return true;
}

/// Writes who holds the lock.
void DirectoryLock::sign() const {
  const std::string text = fmt::format("process {} on {}, since {:%F %T}\n", getpid(), host(),
                                       fmt::localtime(std::time(nullptr)));
  if (ftruncate(file_, 0) != 0 || pwrite(file_, text.data(), text.size(), 0) < 0) return;
}

DirectoryLock::~DirectoryLock() {
  if (file_ < 0) return;
  if (is_at(path_, file_)) unlink(path_.c_str());
  close(file_);
}

DirectoryLock::DirectoryLock(DirectoryLock&& other) noexcept { *this = std::move(other); }

DirectoryLock& DirectoryLock::operator=(DirectoryLock&& other) noexcept {
  std::swap(path_, other.path_);
  std::swap(note_, other.note_);
  std::swap(file_, other.file_);
  return *this;
}

}  // namespace washtub
