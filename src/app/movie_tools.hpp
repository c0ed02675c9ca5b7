#pragma once
#include <string>

namespace washtub {

/// The programs that make a movie, as full paths.
struct MovieTools {
  std::string node, browser, encoder;
  std::string script;  ///< viewer/movie.mjs, installed or of the source tree
};

/// Looks for Node.js, Chromium or Chrome, and ffmpeg on the PATH.
/// @throws RunError naming what is missing and the package that has it
MovieTools find_movie_tools();

}  // namespace washtub
