#pragma once
#include <zlib.h>

#include <cstddef>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace washtub {

/// Deflates (zlib) what comes in parts, so that only the compressed bytes are kept.
class Deflater {
 public:
  Deflater();
  ~Deflater();
  Deflater(const Deflater&) = delete;
  Deflater& operator=(const Deflater&) = delete;

  void add(std::string_view bytes);
  template <class T>
  void add(std::span<const T> values) {
    add({reinterpret_cast<const char*>(values.data()), values.size_bytes()});
  }
  /// All that was added, deflated; nothing may be added afterwards.
  std::string finish();

 private:
  void run(int flush);

  z_stream stream_{};
  std::string out_;
};

/// The binary data of a page: texts in base64 of deflated bytes, known by their numbers.
class Chunks {
 public:
  /// Returns the number of the new chunk.
  int add(Deflater& bytes);
  int add(std::string_view bytes);
  template <class T>
  int add(const std::vector<T>& values) {
    return add({reinterpret_cast<const char*>(values.data()), values.size() * sizeof(T)});
  }
  /// Forgets the chunks from number `count` on.
  void shrink(std::size_t count) { texts_.resize(count); }

  const std::vector<std::string>& texts() const { return texts_; }
  std::size_t size() const;  ///< of all in a page [bytes]

 private:
  std::vector<std::string> texts_;
};

/// The element that carries a chunk.
std::string chunk_element(std::size_t number, const std::string& text);

}  // namespace washtub
