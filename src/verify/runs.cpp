#include "verify/runs.hpp"

#include <algorithm>
#include <filesystem>

namespace washtub {

namespace {

std::string case_path(const Expected& expected, const RunSpec& run) {
  return (std::filesystem::path(expected.directory) / run.file).string();
}

/// The most modes that a quantity or a figure asks of a run.
int modes_of(const Expected& expected, const std::string& run) {
  int most = 1;
  const auto ask = [&](const Measured& what, const std::vector<std::string>& runs) {
    if (std::find(runs.begin(), runs.end(), run) != runs.end()) most = std::max(most, what.mode);
  };
  for (const Quantity& q : expected.quantities) ask(q, q.used_runs());
  for (const Figure& figure : expected.figures)
    for (const Curve& curve : figure.curves) ask(curve, curve.runs);
  return most;
}

/// All that decides what a run computes.
nlohmann::ordered_json fingerprint(const Expected& expected, const RunSpec& run,
                                   const std::string& identity) {
  auto words = run_words(expected, run, "");
  const std::string path = case_path(expected, run);
  std::erase(words, path);
  return {{"program", identity}, {"command", words}, {"case file", hash_of_file(path)}};
}

}  // namespace

std::vector<std::string> run_words(const Expected& expected, const RunSpec& run,
                                   const std::string& directory) {
  std::vector<std::string> words = {run.command, case_path(expected, run)};
  if (run.command == "modes") {
    words.insert(words.end(), {"--count", std::to_string(modes_of(expected, run.name)), "-o",
                               directory + "/modes.json"});
  } else {
    words.insert(words.end(), {"-o", directory, "-n", "1", "--force", "--no-report"});
  }
  for (const std::string& setting : run.settings) words.insert(words.end(), {"--set", setting});
  return words;
}

void make_runs(std::vector<CaseRuns>& cases, const RunPlan& plan) {
  std::vector<BatchRun> batch;
  for (CaseRuns& c : cases) {
    c.runs.resize(c.expected.runs.size());
    for (std::size_t i = 0; i < c.runs.size(); ++i) {
      const RunSpec& run = c.expected.runs[i];
      const std::string name = c.expected.name + '/' + run.name;
      c.runs[i].directory = plan.directory + '/' + name;
      batch.push_back({name, run_words(c.expected, run, c.runs[i].directory),
                       fingerprint(c.expected, run, plan.identity), run.cost,
                       run.level <= plan.level, &c.runs[i]});
    }
  }
  make_batch(batch, plan.batch);
}

}  // namespace washtub
