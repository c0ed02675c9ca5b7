#include "record/build_facts.hpp"

#include <sys/utsname.h>

#include <fstream>

namespace washtub {

extern const char* const commit;  // written by the build, see cmake/Commit.cmake

namespace {

#ifdef __clang__
constexpr const char* compiler = "clang " __clang_version__;
#else
constexpr const char* compiler = "GCC " __VERSION__;
#endif

#if defined(__AVX512F__)
constexpr const char* instructions = "AVX-512";
constexpr int width = 512;
#elif defined(__AVX2__)
constexpr const char* instructions = "AVX2";
constexpr int width = 256;
#elif defined(__AVX__)
constexpr const char* instructions = "AVX";
constexpr int width = 256;
#elif defined(__SSE4_2__)
constexpr const char* instructions = "SSE4.2";
constexpr int width = 128;
#elif defined(__SSE2__)
constexpr const char* instructions = "SSE2";
constexpr int width = 128;
#elif defined(__ARM_NEON)
constexpr const char* instructions = "NEON";
constexpr int width = 128;
#else
constexpr const char* instructions = "none";
constexpr int width = 64;
#endif

}  // namespace

const BuildFacts& build_facts() {
  static const BuildFacts facts{commit, compiler, WASHTUB_PROCESSOR, instructions, width};
  return facts;
}

std::string processor() {
  std::ifstream file("/proc/cpuinfo");
  for (std::string line; std::getline(file, line);)
    if (line.starts_with("model name")) return line.substr(line.find(": ") + 2);
  utsname system{};
  return uname(&system) == 0 ? system.machine : "unknown";
}

}  // namespace washtub
