#include "report/chunk.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <iterator>
#include <utility>

extern "C" {
#include <b64/cencode.h>
}

#include "base/error.hpp"

namespace washtub {
namespace {

constexpr int level = 6;
constexpr std::size_t part = 1 << 20;

/// The library breaks the lines, which a page has no need of.
std::string base64(std::string_view bytes) {
  base64_encodestate state;
  base64_init_encodestate(&state);
  std::string text;
  std::vector<char> buffer(2 * part);
  const auto append = [&](int length) {
    std::remove_copy(buffer.data(), buffer.data() + length, std::back_inserter(text), '\n');
  };
  text.reserve(4 * (bytes.size() / 3 + 1));
  for (; !bytes.empty(); bytes.remove_prefix(std::min(part, bytes.size())))
    append(base64_encode_block(bytes.data(), static_cast<int>(std::min(part, bytes.size())),
                               buffer.data(), &state));
  append(base64_encode_blockend(buffer.data(), &state));
  return text;
}

}  // namespace

Deflater::Deflater() {
  if (deflateInit(&stream_, level) != Z_OK) throw RunError("zlib does not start");
}

Deflater::~Deflater() { deflateEnd(&stream_); }

/// Works off the input that is set.
void Deflater::run(int flush) {
  std::array<char, 65536> buffer;
  do {
    stream_.next_out = reinterpret_cast<Bytef*>(buffer.data());
    stream_.avail_out = buffer.size();
    deflate(&stream_, flush);
    out_.append(buffer.data(), buffer.size() - stream_.avail_out);
  } while (stream_.avail_out == 0);
}

void Deflater::add(std::string_view bytes) {
  for (; !bytes.empty(); bytes.remove_prefix(std::min(part, bytes.size()))) {
    stream_.next_in = reinterpret_cast<Bytef*>(const_cast<char*>(bytes.data()));
    stream_.avail_in = static_cast<uInt>(std::min(part, bytes.size()));
    run(Z_NO_FLUSH);
  }
}

std::string Deflater::finish() {
  stream_.avail_in = 0;
  run(Z_FINISH);
  return std::move(out_);
}

std::string chunk_element(std::size_t number, const std::string& text) {
  return fmt::format("<script type=\"text/plain\" id=\"washtub-chunk-{}\">{}</script>\n", number,
                     text);
}

int Chunks::add(Deflater& bytes) {
  texts_.push_back(base64(bytes.finish()));
  return static_cast<int>(texts_.size()) - 1;
}

int Chunks::add(std::string_view bytes) {
  Deflater deflater;
  deflater.add(bytes);
  return add(deflater);
}

std::size_t Chunks::size() const {
  std::size_t bytes = 0;
  for (std::size_t n = 0; n < texts_.size(); ++n)
    bytes += texts_[n].size() + chunk_element(n, "").size();
  return bytes;
}

}  // namespace washtub
