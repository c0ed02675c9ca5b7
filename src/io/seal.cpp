#include "io/seal.hpp"

#include <fmt/format.h>
#include <zlib.h>

#include <cerrno>
#include <cstring>
#include <fstream>
#include <sstream>
#include <vector>

#include "base/error.hpp"
#include "io/file.hpp"

namespace washtub {
namespace {

/// What a seal says of the rest of its file.
struct Content {
  std::size_t bytes = 0;
  unsigned long crc = 0;
  bool operator==(const Content&) const = default;
};

Content content(std::istream& file) {
  Content found;
  std::vector<char> part(std::size_t{1} << 20);
  file.seekg(seal_size);
  while (file.read(part.data(), static_cast<std::streamsize>(part.size())) || file.gcount() > 0) {
    const auto count = static_cast<std::size_t>(file.gcount());
    found.crc = crc32_z(found.crc, reinterpret_cast<const Bytef*>(part.data()), count);
    found.bytes += count;
  }
  return found;
}

InputError not_sound(const std::string& path, const std::string& reason) {
  return InputError(fmt::format("{}: {}", path, reason));
}

}  // namespace

void seal_file(const std::string& path, const std::string& kind, int version) {
  std::fstream file(path, std::ios::in | std::ios::out | std::ios::binary);
  const Content found = content(file);
  std::string seal =
      fmt::format("washtub {} {}\nbytes {}\ncrc32 {:08x}\n", kind, version, found.bytes, found.crc);
  seal.resize(seal_size, '\0');
  file.clear();
  file.seekp(0);
  if (!file.write(seal.data(), static_cast<std::streamsize>(seal.size())).flush())
    throw RunError(cannot_write(path, errno));
}

void check_seal(const std::string& path, const std::string& kind, int version) {
  std::ifstream file(path, std::ios::binary);
  if (!file) throw not_sound(path, fmt::format("cannot be read: {}", std::strerror(errno)));
  std::string seal(seal_size, '\0');
  if (!file.read(seal.data(), static_cast<std::streamsize>(seal.size())))
    throw not_sound(path, "is cut short, or never finished");
  std::istringstream words(seal);
  std::string name, its_kind, bytes, crc;
  int its_version = 0;
  Content sealed;
  words >> name >> its_kind >> its_version >> bytes >> sealed.bytes >> crc >> std::hex >>
      sealed.crc;
  if (!words || name != "washtub" || its_kind != kind || bytes != "bytes" || crc != "crc32")
    throw not_sound(path, fmt::format("is no {} of washtub, or was never finished", kind));
  if (its_version != version)
    throw not_sound(
        path, fmt::format("is of version {}, this program reads version {}", its_version, version));
  const Content found = content(file);
  if (found.bytes < sealed.bytes)
    throw not_sound(path, fmt::format("is cut short: {} bytes of {}", found.bytes + seal_size,
                                      sealed.bytes + seal_size));
  if (found != sealed)
    throw not_sound(path, fmt::format("is damaged: its checksum is {:08x}, sealed with {:08x}",
                                      found.crc, sealed.crc));
}

}  // namespace washtub
