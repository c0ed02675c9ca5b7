#include "app/start_point.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>

#include "app/directory.hpp"
#include "base/error.hpp"
#include "base/settings.hpp"
#include "io/checkpoint.hpp"

namespace washtub {
namespace {

namespace fs = std::filesystem;

/// Keys that a run may change when it goes on: what it writes, how long it runs,
bool is_output(const std::string& key) {
  return key == "title" || key == "time.end" || key.starts_with("output.") ||
         key.starts_with("checkpoint.");
}

/// and what the reasons for which it gives up ask to change.
bool is_remedy(const std::string& key) {
  return key.starts_with("time.") || key.starts_with("solver.") || key == "coupling.strain_limit";
}

bool is_remedy_sentence(const std::string& sentence) {
  return is_remedy(sentence.substr(0, sentence.find(' ')));
}

Settings physics(const std::string& text, const std::string& name) {
  Settings settings = settings_of(parse_text(text, name));
  std::erase_if(settings, [](const auto& setting) { return is_output(setting.first); });
  return settings;
}

/// The newest sound checkpoint of a run; damaged ones are told of.
std::string newest_of(const std::string& directory) {
  std::vector<std::string> damaged;
  const std::string path = Checkpoints(directory, 1).newest(damaged);
  for (const std::string& sentence : damaged)
    fmt::print(stderr, "washtub: {}; falling back to {}\n", sentence, path);
  return path;
}

/// Whether statistics that were begun over one window can go on over another: not yet begun, or
/// collected cycle by cycle up to the checkpoint.
bool window_may_change(const CheckpointLabel& label, const Case& whole) {
  const double begin = whole.output.window_begin, end = whole.output.window_end;
  if (begin == label.window_begin && end == label.window_end) return true;
  const double t = label.time * (1 - 1e-9);
  if (t <= std::min(begin, label.window_begin)) return true;
  return whole.scale.period > 0 && begin == label.window_begin &&
         t <= std::min(end, label.window_end);
}

/// Returns how the case differs from the checkpoint's, where it may.
std::vector<std::string> check_case(const std::string& checkpoint, const Case& whole) {
  const CheckpointLabel label = read_label(checkpoint);
  auto differing =
      differences(physics(label.case_text, checkpoint), physics(whole.resolved, "case"));
  const auto remedies = std::partition(differing.begin(), differing.end(),
                                       [](const auto& s) { return !is_remedy_sentence(s); });
  if (remedies != differing.begin())
    throw InputError(fmt::format(
        "{}: is of another case: {}; only [time], [output], [checkpoint], [solver], "
        "coupling.strain_limit and the title may change when a run goes on; to start another case "
        "from its water and cloth use --from",
        checkpoint, fmt::join(differing.begin(), remedies, "; ")));
  if (!window_may_change(label, whole))
    throw InputError(fmt::format(
        "{}: its statistics are those of output.window = [\"{:.6g} s\", \"{:.6g} s\"] and cannot "
        "go on over [\"{:.6g} s\", \"{:.6g} s\"]; leave the window as it was",
        checkpoint, label.window_begin, label.window_end, whole.output.window_begin,
        whole.output.window_end));
  if (whole.time.end < label.time)
    throw InputError(fmt::format("{}: is at t = {:.6g} s, beyond time.end = \"{:.6g} s\"",
                                 checkpoint, label.time, whole.time.end));
  return differing;
}

/// Whether a directory has nothing to go on from and no results of a complete run either.
bool never_saved(const std::string& directory) {
  if (!Checkpoints(directory, 1).list().empty()) return false;
  std::ifstream file(fs::path(directory) / "summary.json");
  const auto summary = nlohmann::json::parse(file, nullptr, false);
  return summary.is_discarded() ||
         summary.value(nlohmann::json::json_pointer("/run/outcome"), std::string()) != "complete";
}

}  // namespace

void settle_directory(RunArguments& arguments) {
  std::string& path = arguments.input.path;
  if (arguments.resume && fs::is_directory(path)) {
    if (arguments.directory.empty()) arguments.directory = path;
    path = (fs::path(path) / "case.toml").string();
  }
  if (arguments.directory.empty()) arguments.directory = default_directory(path);
}

DirectoryLock prepare_start(const RunArguments& arguments, const Case& whole, RunOptions& options) {
  if (!arguments.from.empty())
    options.developed =
        fs::is_directory(arguments.from) ? newest_of(arguments.from) : arguments.from;
  if (!options.developed.empty()) check_checkpoint(options.developed);
  if (!arguments.resume || never_saved(options.directory)) {
    if (arguments.resume)
      fmt::print(stderr, "washtub: {}: no checkpoint yet, starting from the beginning\n",
                 options.directory);
    else
      protect_case(arguments.input.path, options.directory);
    return prepare_directory(options.directory, options.force || arguments.resume);
  }
  DirectoryLock lock(options.directory);
  options.resumed = newest_of(options.directory);
  options.changes = check_case(options.resumed, whole);
  return lock;
}

}  // namespace washtub
