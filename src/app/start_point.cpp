#include "app/start_point.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <chrono>
#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>

#include "app/directory.hpp"
#include "base/error.hpp"
#include "base/settings.hpp"
#include "batch/batch.hpp"
#include "io/checkpoint.hpp"
#include "io/file.hpp"

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

/// Whether statistics that were begun over one window can go on over another: one that is not yet
/// begun, or, collected cycle by cycle, ends later.
bool window_may_change(const CheckpointLabel& label, const Case& whole) {
  if (whole.cloth.empty()) return true;
  const double begin = whole.output.window_begin, end = whole.output.window_end;
  if (begin == label.window_begin && end == label.window_end) return true;
  const double t = label.time * (1 - 1e-9);
  if (t <= begin) return true;
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
  if (whole.time.end < label.time)
    throw InputError(fmt::format("{}: is at t = {:.6g} s, beyond time.end = \"{:.6g} s\"",
                                 checkpoint, label.time, whole.time.end));
  if (!window_may_change(label, whole))
    throw InputError(fmt::format(
        "{}: its statistics are those of output.window = [\"{:.6g} s\", \"{:.6g} s\"] and cannot "
        "go on over [\"{:.6g} s\", \"{:.6g} s\"]; add --set 'output.window=[\"{:.9g} s\", "
        "\"{:.9g} s\"]'",
        checkpoint, label.window_begin, label.window_end, whole.output.window_begin,
        whole.output.window_end, label.window_begin, label.window_end));
  return differing;
}

}  // namespace

bool is_complete(const std::string& directory) {
  std::ifstream file(fs::path(directory) / "summary.json");
  const auto summary = nlohmann::json::parse(file, nullptr, false);
  const nlohmann::json::json_pointer outcome("/run/outcome");
  return !summary.is_discarded() && summary.value(outcome, std::string()) == "complete";
}

namespace {

/// Whether a run of the same case has begun in a directory, but has not computed for much longer
/// than it takes to a first checkpoint, and has not ended by itself: little is lost if it starts
/// anew.
bool hardly_begun(const std::string& directory, const Case& whole) {
  const fs::path folder = directory;
  std::error_code none;
  if (!fs::exists(folder / "case.toml") || !differing_case(directory, whole).empty()) return false;
  if (!fs::exists(folder / "history.csv") && !fs::exists(folder / "summary.json") &&
      fs::exists(folder / "log.txt"))
    return true;
  const auto begun = fs::last_write_time(folder / "case.toml", none);
  const auto written = fs::last_write_time(folder / "history.csv", none);
  if (none || is_complete(directory)) return false;
  const std::chrono::duration<double> computed = written - begun;
  return computed.count() <= 2 * std::max(whole.checkpoint.wall_time, 60.0);
}

/// The water and cloth of another run must fit into this one.
void check_developed(const std::string& checkpoint, const Case& whole) {
  const std::string text = read_label(checkpoint).case_text;
  const Case other = read_case_text(text, checkpoint);
  const auto require = [&](bool same, const std::string& what) {
    if (!same)
      throw InputError(
          fmt::format("{}: has another {}, so that its water and cloth cannot start "
                      "this case",
                      checkpoint, what));
  };
  require(other.dimension == whole.dimension, "dimension");
  const auto &there = other.domain, &here = whole.domain;
  require(there.cells == here.cells, "domain.cells");
  const auto rest_size = [](const ClothCase& cloth) {
    return Vec<3>(cloth.size[0], cloth.size[1], 0);
  };
  const auto near = [](const Vec<3>& a, const Vec<3>& b) {
    return (a - b).norm() <= 1e-9 * (a.norm() + b.norm());
  };
  require(near(there.size, here.size) && near(there.lower, here.lower), "domain (size, lower)");
  require(other.cloth.size() == whole.cloth.size(), "number of [[cloth]] groups");
  for (std::size_t g = 0; g < whole.cloth.size(); ++g) {
    const std::string group = fmt::format("cloth[{}]", g + 1);
    require(other.cloth[g].count == whole.cloth[g].count, group + ".count");
    require(near(rest_size(other.cloth[g]), rest_size(whole.cloth[g])), group + ".size");
    require(cloth_nodes(other.cloth[g], other) == cloth_nodes(whole.cloth[g], whole),
            group + ".nodes");
  }
}

}  // namespace

std::vector<std::string> differing_case(const std::string& directory, const Case& whole) {
  const std::string there = (fs::path(directory) / "case.toml").string();
  if (!fs::exists(there)) return {};
  auto differing = differences(physics(read_file(there), there), physics(whole.resolved, "case"));
  if (!is_complete(directory)) std::erase_if(differing, is_remedy_sentence);
  return differing;
}

void check_going_on(const std::string& directory, const Case& whole) {
  if (!Checkpoints(directory, 1).list().empty()) check_case(newest_of(directory), whole);
}

void settle_directory(RunArguments& arguments) {
  std::string& path = arguments.input.path;
  if (arguments.resume && fs::is_directory(path)) {
    std::error_code none;
    if (!fs::exists(fs::path(path) / "history.csv"))
      throw InputError(
          fmt::format("{}: holds no run to go on with; name a case file, and the "
                      "directory of its results with -o",
                      path));
    if (!arguments.directory.empty() && !fs::equivalent(path, arguments.directory, none))
      throw InputError(
          fmt::format("-o {}: a run goes on in its own directory, {}; to start "
                      "another one from its water and cloth use --from",
                      arguments.directory, path));
    arguments.directory = path;
    path = (fs::path(path) / "case.toml").string();
  }
  if (arguments.directory.empty()) arguments.directory = default_directory(path);
}

namespace {

/// The checkpoint of another run that a new one starts with; it must still be there when the
/// results in the new one's directory are gone.
std::string developed_start(const std::string& from, const std::string& directory) {
  const std::string path = fs::is_directory(from) ? newest_of(from) : from;
  const std::string relative = fs::relative(fs::absolute(path), fs::absolute(directory)).string();
  if (!relative.starts_with("..") && fs::exists(path))
    throw InputError(
        fmt::format("--from {}: lies in {}, whose results would be overwritten; name "
                    "another directory with -o",
                    from, directory));
  return path;
}

DirectoryLock start_anew(const RunArguments& arguments, const Case& whole, RunOptions& options) {
  if (!arguments.from.empty()) {
    options.developed = developed_start(arguments.from, options.directory);
    check_developed(options.developed, whole);
  }
  const bool again = arguments.resume && hardly_begun(options.directory, whole);
  if (arguments.resume && !again && !options.force &&
      fs::exists(fs::path(options.directory) / "history.csv"))
    throw InputError(
        fmt::format("{}: holds results of another case, or of a long run, but no checkpoint to go "
                    "on from; name "
                    "another directory with -o, or start anew with --force",
                    options.directory));
  if (again)
    fmt::print(stderr, "washtub: {}: no checkpoint yet, starting from the beginning\n",
               options.directory);
  else
    protect_case(arguments.input.path, options.directory);
  return prepare_directory(options.directory, options.force || again);
}

}  // namespace

DirectoryLock prepare_start(const RunArguments& arguments, const Case& whole, RunOptions& options) {
  if (!arguments.resume || Checkpoints(options.directory, 1).list().empty())
    return start_anew(arguments, whole, options);
  DirectoryLock lock(options.directory);
  remove_unfinished(options.directory);
  fs::remove(fs::path(options.directory) / finished_mark);
  options.resumed = newest_of(options.directory);
  options.changes = check_case(options.resumed, whole);
  return lock;
}

}  // namespace washtub
