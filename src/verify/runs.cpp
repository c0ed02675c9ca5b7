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
  const std::string path = case_path(expected, run);
  std::vector<std::string> words;
  if (run.command == "modes")
    words = {"modes",   path,
             "--count", std::to_string(modes_of(expected, run.name)),
             "-o",      directory + "/modes.json"};
  else if (run.seeds.empty())
    words = {"run", path, "-o", directory, "-n", "1", "--no-report"};
  else
    words = {"ensemble", path, "-o", directory, "-j", "1", "--seeds", run.seeds};
  for (const std::string& setting : run.settings) words.insert(words.end(), {"--set", setting});
  return words;
}

namespace {

/// A run of the batch: begun anew, or gone on with where it was interrupted.
BatchRun batch_run(const CaseRuns& of, std::size_t i, const RunPlan& plan) {
  const RunSpec& run = of.expected.runs[i];
  BatchRun result;
  result.name = of.expected.name + '/' + run.name;
  result.words = result.again = run_words(of.expected, run, plan.directory + '/' + result.name);
  if (run.command == "run") {
    result.words.emplace_back("--force");
    if (run.seeds.empty()) result.again.emplace_back("--resume");
    result.trace = run.seeds.empty() ? "log.txt" : "ensemble.json";
  }
  result.fingerprint = fingerprint(of.expected, run, plan.identity);
  result.cost = run.cost;
  result.wanted = run.level <= plan.level;
  return result;
}

}  // namespace

void make_runs(std::vector<CaseRuns>& cases, const RunPlan& plan) {
  std::vector<BatchRun> batch;
  for (CaseRuns& c : cases) {
    c.runs.resize(c.expected.runs.size());
    for (std::size_t i = 0; i < c.runs.size(); ++i) {
      batch.push_back(batch_run(c, i, plan));
      batch.back().result = &c.runs[i];
      c.runs[i].directory = plan.directory + '/' + batch.back().name;
    }
  }
  make_batch(batch, plan.batch);
}

}  // namespace washtub
