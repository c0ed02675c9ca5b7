#pragma once
#include <cstddef>
#include <string>

namespace washtub {

/// Bytes at the start of a file that its seal takes.
constexpr std::size_t seal_size = 512;

/// Writes into the first bytes of a finished file what it is, its size and the CRC-32 of all that
/// follows: "washtub checkpoint 1", "bytes 1234", "crc32 89abcdef", a line each. `version`: of what
/// such files hold.
/// @throws RunError
void seal_file(const std::string& path, const std::string& kind, int version);

/// @throws InputError where the file is not of this kind and version, is truncated, or a bit of it
/// differs from what was sealed
void check_seal(const std::string& path, const std::string& kind, int version);

}  // namespace washtub
