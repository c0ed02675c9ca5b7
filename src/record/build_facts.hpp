#pragma once
#include <string>

namespace washtub {

/// What this program was made of: results of a chaotic flow differ from build to build.
struct BuildFacts {
  std::string commit;        ///< "4e74dd7a1b2c", "-dirty" added where the sources differ; "unknown"
  std::string compiler;      ///< "GCC 12.2.0"
  std::string target;        ///< processor asked for: "native", "portable", "x86-64-v3"
  std::string instructions;  ///< widest vector instructions that were allowed: "AVX-512"
  int vector_width;          ///< of these [bit]
};
const BuildFacts& build_facts();

/// The processor that this runs on: "AMD EPYC 9354"; its architecture where it has no name.
std::string processor();

}  // namespace washtub
