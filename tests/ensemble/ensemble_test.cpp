#include "ensemble/ensemble.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

#include "base/error.hpp"
#include "support/run_folder.hpp"

namespace washtub {
namespace {

using ::testing::Contains;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::Not;
using testing::RunFolder;
using ::testing::ThrowsMessage;

/// A folder "all" of members whose stress is `level` in the mean of the window's three cycles, with
/// `step` from each to the next.
class Members {
 public:
  explicit Members(const std::string& name = "all") : name_(name) {}
  static std::string seeded(std::uint64_t seed) {
    std::string text = RunFolder::case_text();
    return text.replace(text.find("[[cloth]]"), 9, "[[cloth]]\nseed = " + std::to_string(seed));
  }
  void add(const RunFolder& folder, std::uint64_t seed, double level, double step) {
    folder.run(name_ + "/seed-" + std::to_string(seed),
               {.stress = [=](double t) { return level + step * (std::ceil(t - 1e-6) - 3); }},
               seeded(seed));
    seeds_.push_back(seed);
    write_members(folder.path(name_), seeds_);
  }

 private:
  std::string name_;
  std::vector<std::uint64_t> seeds_;
};

const PooledQuantity& stress_of(const Ensemble& ensemble) {
  for (const PooledQuantity& quantity : ensemble.quantities)
    if (quantity.about.name == "stress") return quantity;
  throw std::out_of_range("stress");
}

TEST(Ensemble, PoolsWhatItsMembersHave) {
  const RunFolder folder;
  Members members;
  members.add(folder, 1, 100, 2);
  members.add(folder, 2, 110, 2);
  members.add(folder, 4, 120, 2);
  ASSERT_TRUE(is_ensemble(folder.path("all")));
  EXPECT_FALSE(is_ensemble(folder.path("all/seed-1")));
  const Ensemble ensemble = read_ensemble(folder.path("all"));
  EXPECT_EQ(ensemble.name, "all");
  EXPECT_THAT(ensemble.seeds, ElementsAre(1, 2, 4));
  const PooledQuantity& stress = stress_of(ensemble);
  EXPECT_NEAR(stress.pool.mean, 110, 1e-9);
  EXPECT_NEAR(stress.pool.deviation, 10, 1e-9);
  EXPECT_NEAR(stress.pool.ratio, 100 / (4.0 / 3), 1e-6);
  EXPECT_NEAR(stress.drift.change, 4, 1e-9);
  EXPECT_THAT(stress.about.seeds, ElementsAre(1, 2, 4));
  const auto json = to_json(ensemble);
  EXPECT_EQ(json["rows"][0]["name"], "stress");
  EXPECT_NEAR(json["student"], 4.302653, 1e-6);
  EXPECT_TRUE(json["rows"][0]["cycles_for_5_percent"].is_null());  // cycles do not tell it
}

TEST(Ensemble, SaysWhatItsMembersDifferBy) {
  const RunFolder folder;
  Members apart("apart"), alike("alike"), same("same");
  for (const int seed : {1, 2, 3}) {
    apart.add(folder, seed, 100 + 10 * seed, 2);
    alike.add(folder, seed, 100 + seed, 5);
    same.add(folder, seed, 100, 5);
  }
  EXPECT_THAT(sentences(read_ensemble(folder.path("apart"))),
              Contains(HasSubstr("too narrow for stress")));
  const auto good = sentences(read_ensemble(folder.path("alike")));
  EXPECT_THAT(good, Contains(HasSubstr("cover the spread")));
  EXPECT_THAT(good, Contains(HasSubstr("drift: stress +10 %")));
  EXPECT_THAT(good, Contains(HasSubstr("stress is known to within 2.4 %.")));
  EXPECT_THAT(sentences(read_ensemble(folder.path("same"))),
              ElementsAre(HasSubstr("All members are the same")));
}

TEST(Ensemble, OneCycleEachTellsNoSpread) {
  const RunFolder folder;
  Members members;
  for (const int seed : {1, 2}) {
    members.add(folder, seed, 100 + seed, 1);
    folder.write("all/seed-" + std::to_string(seed) + "/history.csv",
                 RunFolder::history({.stress = [=](double) { return 100.0 + seed; }}, 2.5));
  }
  EXPECT_THAT(sentences(read_ensemble(folder.path("all"))),
              Contains(HasSubstr("fewer than two whole cycles in the window")));
}

/// Members are independent whatever their order looks like.
TEST(Ensemble, RisingMembersAreNoBlocks) {
  const RunFolder folder;
  Members members;
  for (int seed = 1; seed <= 8; ++seed) members.add(folder, seed, 100 + seed, 1);
  const Ensemble ensemble = read_ensemble(folder.path("all"));
  const PooledQuantity& stress = stress_of(ensemble);
  EXPECT_NEAR(*stress.about.half_width(), stress.pool.half_width, 1e-9);
}

TEST(Ensemble, LeavesOutWhatHasNotReachedItsEnd) {
  const RunFolder folder;
  Members members;
  members.add(folder, 1, 100, 2);
  members.add(folder, 2, 110, 2);
  folder.write("all/seed-2/summary.json", R"({"run": {"outcome": "stopped"}})");
  const Ensemble ensemble = read_ensemble(folder.path("all"));
  EXPECT_THAT(ensemble.seeds, ElementsAre(1));
  EXPECT_THAT(ensemble.missing, ElementsAre(2));
  EXPECT_THAT(sentences(ensemble), ElementsAre(HasSubstr("Only one member")));
  folder.write("all/seed-1/summary.json", R"({"run": {"outcome": "failed"}})");
  EXPECT_THAT([&] { read_ensemble(folder.path("all")); },
              ThrowsMessage<InputError>(HasSubstr("none of its 2 members has reached its end")));
  folder.write("all/ensemble.json", "{");
  EXPECT_THAT([&] { read_ensemble(folder.path("all")); },
              ThrowsMessage<InputError>(HasSubstr("is damaged")));
}

/// Starts that scatter by 30 % hide a difference of 2 %; runs that start alike do not.
TEST(CompareEnsembles, PairsRunsThatStartAlike) {
  const RunFolder folder;
  Members one("one"), other("other"), third("third");
  for (const int seed : {1, 2, 3}) {
    one.add(folder, seed, 100 + 30 * seed, 1);
    other.add(folder, seed, 103 + 30 * seed + 0.1 * (seed - 2), 1);
    third.add(folder, seed + 3, 103 + 30 * seed, 1);
  }
  const auto against = [&](const std::string& name) {
    std::vector<Compared> both;
    both.push_back(compared(read_ensemble(folder.path("one"))));
    both.push_back(compared(read_ensemble(folder.path(name))));
    prepare_comparison(both);
    return compare(both);
  };
  Members partly("partly");
  for (const int seed : {2, 3, 4}) partly.add(folder, seed, 103 + 30 * seed, 1);
  EXPECT_FALSE(against("partly").rows[0].against[1]->paired);
  const RunComparison alike = against("other"), apart = against("third");
  EXPECT_TRUE(alike.rows[0].against[1]->paired);
  EXPECT_NEAR(alike.rows[0].against[1]->difference, 3, 1e-9);
  EXPECT_NEAR(*alike.rows[0].against[1]->half_width, 4.302653 * 0.1 / std::sqrt(3), 1e-5);
  EXPECT_EQ(alike.rows[0].against[1]->significant(), true);
  EXPECT_FALSE(apart.rows[0].against[1]->paired);
  EXPECT_EQ(apart.rows[0].against[1]->significant(), false);
  EXPECT_THAT(alike.sentences, Contains(HasSubstr("spread between runs with other seeds")));
  EXPECT_THAT(alike.sentences, Not(Contains(HasSubstr("come from the cycles of one run each"))));
}

}  // namespace
}  // namespace washtub
