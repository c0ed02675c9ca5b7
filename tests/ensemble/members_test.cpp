#include "ensemble/members.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "base/error.hpp"

namespace washtub {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::ThrowsMessage;

Case with_seeds(const std::vector<std::uint64_t>& seeds) {
  Case whole;
  for (const auto seed : seeds) {
    whole.cloth.emplace_back();
    whole.cloth.back().seed = seed;
    whole.cloth.back().count = 2;
  }
  return whole;
}

TEST(ParseSeeds, CountOrRange) {
  EXPECT_THAT(parse_seeds("3"), ElementsAre(1, 2, 3));
  EXPECT_THAT(parse_seeds("6-8"), ElementsAre(6, 7, 8));
  for (const char* wrong : {"", "1", "0", "-3", "3-", "8-6", "2-2", "3,4", "1e3", "5 ", "0-4"})
    EXPECT_THAT([&] { parse_seeds(wrong); },
                ThrowsMessage<InputError>(HasSubstr("as in 5, or the first and the last")))
        << wrong;
  EXPECT_THROW(parse_seeds("10002"), InputError);
}

TEST(MemberSettings, TheFirstIsTheCaseItself) {
  EXPECT_THAT(member_settings(with_seeds({1, 1}), 1),
              ElementsAre("cloth[1].seed=1", "cloth[2].seed=1"));
  EXPECT_THAT(member_settings(with_seeds({7, 9}), 1),
              ElementsAre("cloth[1].seed=7", "cloth[2].seed=9"));
}

/// Else a group of one member would start as another group of the next.
TEST(MemberSettings, NoTwoMembersShareASeed) {
  EXPECT_THAT(member_settings(with_seeds({1, 1}), 4),
              ElementsAre("cloth[1].seed=4", "cloth[2].seed=4"));
  EXPECT_THAT(member_settings(with_seeds({1, 2, 4}), 2),
              ElementsAre("cloth[1].seed=5", "cloth[2].seed=6", "cloth[3].seed=8"));
}

TEST(MemberSettings, RefusesWhatIsNotDrawn) {
  Case whole = with_seeds({1});
  for (const Arrangement fixed : {Arrangement::sheet, Arrangement::ring}) {
    whole.cloth[0].arrangement = fixed;
    EXPECT_THAT([&] { member_settings(whole, 2); },
                ThrowsMessage<InputError>(HasSubstr("nothing in this case is drawn at random")));
  }
  EXPECT_THROW(member_settings(Case(), 2), InputError);
}

}  // namespace
}  // namespace washtub
