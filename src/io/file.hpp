#pragma once
#include <string>
#include <string_view>

namespace washtub {

/// "cannot write PATH: reason", for the error number of a failed system call.
std::string cannot_write(const std::string& path, int error_number);

/// The whole file. @throws InputError with path and reason
std::string read_file(const std::string& path);

/// Puts `text` in place of the file at once: readers see the old content or the new, never a part.
/// Written under a temporary name beside it and renamed.
/// @throws RunError with path and reason; the old file is then as it was and nothing is left over
void replace_file(const std::string& path, std::string_view text);

/// Makes sure that a finished PATH.part is on the disk and puts it in its place, for good.
/// @throws RunError with path and reason; then PATH is as it was
void publish_file(const std::string& path);

}  // namespace washtub
