#include "record/build_facts.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace washtub {
namespace {

using ::testing::MatchesRegex;
using ::testing::StartsWith;

TEST(BuildFacts, NameCommitAndCompiler) {
  EXPECT_THAT(build_facts().commit, MatchesRegex("unknown|[0-9a-f]{12,}(-dirty)?"));
  EXPECT_THAT(build_facts().compiler, MatchesRegex("(GCC|clang) [1-9][0-9]*\\.[0-9].*"));
}

TEST(BuildFacts, WidthIsThatOfTheInstructions) {
#if defined(__x86_64__)
  const int bits = build_facts().vector_width;
  EXPECT_THAT(build_facts().instructions, StartsWith(bits == 512   ? "AVX-512"
                                                     : bits == 256 ? "AVX"
                                                                   : "SSE"));
#endif
  for (const auto& [target, instructions] :
       {std::pair{"x86-64-v2", "SSE4.2"}, std::pair{"x86-64-v3", "AVX2"}})
    EXPECT_TRUE(build_facts().target != target || build_facts().instructions == instructions);
}

TEST(BuildFacts, ProcessorHasAName) {
  EXPECT_THAT(processor(), MatchesRegex("[^ \n].*[^ \n]"));
  EXPECT_NE(processor(), "unknown");
}

}  // namespace
}  // namespace washtub
