#include "base/snapshot.hpp"

#include <cstring>

namespace washtub {

void Snapshot::Taker::list(const std::string&, Number kind, void* data, std::size_t count) {
  const std::size_t size = count * size_of(kind);
  if (size > 0 && at_ + size <= bytes_.size()) std::memcpy(bytes_.data() + at_, data, size);
  at_ += size;
}

std::size_t Snapshot::Taker::length(const std::string& path, std::size_t now) {
  long length = static_cast<long>(now);
  list(path, Number::int64, &length, 1);
  return now;
}

void Snapshot::Giver::list(const std::string&, Number kind, void* data, std::size_t count) {
  const std::size_t size = count * size_of(kind);
  if (size > 0) std::memcpy(data, bytes_.data() + at_, size);
  at_ += size;
}

std::size_t Snapshot::Giver::length(const std::string& path, std::size_t) {
  long length = 0;
  list(path, Number::int64, &length, 1);
  return static_cast<std::size_t>(length);
}

}  // namespace washtub
