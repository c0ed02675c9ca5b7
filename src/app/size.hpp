#pragma once
#include <cstddef>
#include <string>

namespace washtub {

/// Bytes of a largest size such as "20 MB", "500 kB", "1.5 GB" (powers of ten) or "20", which is in
/// MB.
/// @throws InputError naming --max-size
std::size_t parse_size(const std::string& text);

}  // namespace washtub
