#include "io/reserve.hpp"

#include <fcntl.h>
#include <unistd.h>

#include <cerrno>
#include <cstdio>

#include "io/agree.hpp"
#include "io/file.hpp"

namespace washtub {
namespace {

/// The error number of the failure, 0 if there is room or the file system does not tell.
int make_room(const std::string& path, std::size_t bytes) {
  const int file = ::open(path.c_str(), O_WRONLY | O_CREAT | O_CLOEXEC, 0666);
  if (file < 0) return errno;
  const int error = ::posix_fallocate(file, 0, static_cast<::off_t>(bytes));
  ::close(file);
  return error == ENOSPC || error == EFBIG || error == EDQUOT ? error : 0;
}

}  // namespace

void reserve_file(const std::string& path, std::size_t bytes, const Parallel& parallel) {
  const std::string temporary = path + ".part";
  const int error = parallel.root() ? make_room(temporary, bytes) : 0;
  if (error != 0) std::remove(temporary.c_str());
  agree(parallel, error != 0 ? cannot_write(path, error) : std::string());
}

}  // namespace washtub
