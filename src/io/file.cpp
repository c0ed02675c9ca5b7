#include "io/file.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <cstdio>
#include <cstring>
#include <filesystem>

#include "base/error.hpp"

namespace washtub {
namespace {

/// The error number of the failure, 0 if all went well.
int write_whole(const std::string& path, std::string_view text) {
  std::FILE* file = std::fopen(path.c_str(), "wb");
  if (file == nullptr) return errno;
  const bool written = std::fwrite(text.data(), 1, text.size(), file) == text.size();
  const int error = written && std::fflush(file) == 0 && ::fsync(::fileno(file)) == 0 ? 0 : errno;
  if (std::fclose(file) != 0 && error == 0) return errno;
  return error;
}

/// Waits until a file or directory is on the disk. The error number of the failure, 0 if none.
int sync(const std::string& path, int flags) {
  const int file = ::open(path.c_str(), flags | O_CLOEXEC);
  if (file < 0) return errno;
  const int error = ::fsync(file) == 0 ? 0 : errno;
  ::close(file);
  return error;
}

}  // namespace

std::string cannot_write(const std::string& path, int error_number) {
  return fmt::format("cannot write {}: {}", path, std::strerror(error_number));
}

std::string read_file(const std::string& path) {
  const auto fail = [&](int error) {
    throw InputError(fmt::format("cannot read {}: {}", path, std::strerror(error)));
  };
  std::FILE* file = std::fopen(path.c_str(), "rb");
  if (file == nullptr) fail(errno);
  std::string text;
  std::array<char, 1 << 16> part;
  while (const std::size_t count = std::fread(part.data(), 1, part.size(), file))
    text.append(part.data(), count);
  const int error = std::ferror(file) ? errno : 0;
  std::fclose(file);
  if (error != 0) fail(error);
  return text;
}

void replace_file(const std::string& path, std::string_view text) {
  const std::string temporary = path + ".part";
  int error = write_whole(temporary, text);
  if (error == 0 && std::rename(temporary.c_str(), path.c_str()) != 0) error = errno;
  if (error == 0) return;
  std::remove(temporary.c_str());
  throw RunError(cannot_write(path, error));
}

void publish_file(const std::string& path) {
  const std::string temporary = path + ".part";
  int error = sync(temporary, O_WRONLY);
  if (error == 0 && std::rename(temporary.c_str(), path.c_str()) != 0) error = errno;
  if (error == 0)
    error = sync(std::filesystem::path(path).parent_path().string(), O_RDONLY | O_DIRECTORY);
  if (error == 0) return;
  std::remove(temporary.c_str());
  throw RunError(cannot_write(path, error));
}

}  // namespace washtub
