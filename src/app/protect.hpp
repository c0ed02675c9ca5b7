#pragma once
#include <string>

namespace washtub {

/// What this program writes is put in the place of its own kind only.
/// @throws InputError where something stands at the path that is no page of washtub
void protect_page(const std::string& path);
/// @throws InputError where something stands at the path that is no MP4 movie
void protect_movie(const std::string& path);

/// The same of what `washtub modes` writes.
void protect_modes(const std::string& path);
/// The same of what `washtub bench` writes.
void protect_speeds(const std::string& path);

}  // namespace washtub
