#pragma once
#include <cstdint>
#include <string>
#include <string_view>

#include "base/error.hpp"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size);
/// Called once before all inputs, where a target has it.
extern "C" int LLVMFuzzerInitialize(int* argc, char*** argv);

namespace washtub::fuzz {

inline std::string_view text_of(const std::uint8_t* data, std::size_t size) {
  return {reinterpret_cast<const char*>(data), size};
}

/// Runs what reads hostile input, which it may refuse in our words. Anything else that comes out,
/// such as std::bad_alloc, ends the program. Returns whether the input was taken.
template <class Read>
bool takes(Read&& read) {
  try {
    read();
    return true;
  } catch (const InputError&) {
  } catch (const RunError&) {
  }
  return false;
}

/// Calls visit(line), without its end, for every line.
template <class Visit>
void for_lines(std::string_view text, Visit&& visit) {
  while (!text.empty()) {
    const auto end = text.find('\n');
    visit(text.substr(0, end));
    text = end == std::string_view::npos ? "" : text.substr(end + 1);
  }
}

}  // namespace washtub::fuzz
