#pragma once
#include <zlib.h>

#include <cstring>
#include <stdexcept>
#include <string>
#include <vector>

namespace washtub {

inline std::string from_base64(const std::string& text) {
  const std::string letters = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  std::string bytes;
  unsigned bits = 0;
  int count = 0;
  for (const char c : text) {
    if (c == '=') break;
    const auto value = letters.find(c);
    if (value == std::string::npos) throw std::runtime_error("no base64");
    bits = bits << 6 | static_cast<unsigned>(value);
    if ((count += 6) < 8) continue;
    count -= 8;
    bytes += static_cast<char>(bits >> count & 255U);
  }
  return bytes;
}

/// The bytes of a chunk's text, as a browser gets them.
inline std::string inflate(const std::string& text) {
  const std::string deflated = from_base64(text);
  std::string bytes(16 * deflated.size() + (1 << 20), 0);
  for (;; bytes.resize(4 * bytes.size())) {
    uLongf size = bytes.size();
    const int code = uncompress(reinterpret_cast<Bytef*>(bytes.data()), &size,
                                reinterpret_cast<const Bytef*>(deflated.data()), deflated.size());
    if (code == Z_BUF_ERROR && bytes.size() < (1U << 30)) continue;
    if (code != Z_OK) throw std::runtime_error("cannot be inflated");
    bytes.resize(size);
    return bytes;
  }
}

/// The same as numbers.
template <class T>
std::vector<T> inflate_as(const std::string& text) {
  const std::string bytes = inflate(text);
  std::vector<T> values(bytes.size() / sizeof(T));
  std::memcpy(values.data(), bytes.data(), values.size() * sizeof(T));
  return values;
}

}  // namespace washtub
