#pragma once
#include <stdlib.h>
#include <unistd.h>

#include <cstdint>
#include <filesystem>
#include <fstream>
#include <string>
#include <string_view>

namespace washtub::fuzz {

/// A file for one input after the other, in TMPDIR.
class ScratchFile {
 public:
  ScratchFile() { ::close(mkstemp(path_.data())); }
  ~ScratchFile() { std::filesystem::remove(path_); }
  ScratchFile(const ScratchFile&) = delete;
  ScratchFile& operator=(const ScratchFile&) = delete;

  const std::string& path() const { return path_; }
  void write(std::string_view text) const { std::ofstream(path_, std::ios::binary) << text; }

 private:
  std::string path_ = std::filesystem::temp_directory_path() / "washtub_fuzz_XXXXXX";
};

/// A binary file out of hostile input: the input itself where it is long, else the file `sound`
/// with the edits that the input lists, each an offset (two bytes, the lower one first), a number
/// of bytes less one, and these bytes.
inline std::string damaged(std::string sound, std::string_view input) {
  if (input.size() >= 512) return std::string(input);
  while (input.size() >= 4) {
    const auto byte = [&](std::size_t i) { return static_cast<std::uint8_t>(input[i]); };
    const std::size_t at = (byte(0) + std::size_t{256} * byte(1)) % sound.size();
    const std::string_view edit = input.substr(3, byte(2) % 16U + 1U).substr(0, sound.size() - at);
    sound.replace(at, edit.size(), edit);
    input.remove_prefix(3 + edit.size());
  }
  return sound;
}

}  // namespace washtub::fuzz
