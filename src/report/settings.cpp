#include "report/settings.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <map>

#include "base/settings.hpp"

namespace washtub {
namespace {

constexpr std::size_t most_sentences = 30;

/// Those of a run's case, but for its title.
Settings settings_of(const RunRecord& run) {
  Settings settings = settings_of(parse_text(run.case_text, run.directory + "/case.toml"));
  std::erase_if(settings, [](const auto& setting) { return setting.first == "title"; });
  return settings;
}

/// "3 in A and C, 4 in B"; runs that lack the key come last.
std::string values_text(const std::vector<const RunRecord*>& runs,
                        const std::vector<std::map<std::string, std::string>>& settings,
                        const std::string& key) {
  std::vector<std::pair<std::string, std::vector<std::string>>> holders;
  for (std::size_t i = 0; i < runs.size(); ++i) {
    const auto found = settings[i].find(key);
    const std::string value = found == settings[i].end() ? "not set" : found->second;
    const auto same = std::find_if(holders.begin(), holders.end(),
                                   [&](const auto& holder) { return holder.first == value; });
    if (same == holders.end())
      holders.push_back({value, {runs[i]->name}});
    else
      same->second.push_back(runs[i]->name);
  }
  if (holders.size() == 1) return "";
  std::vector<std::string> parts;
  for (const auto& [value, names] : holders)
    parts.push_back(fmt::format("{} in {}", value, fmt::join(names, " and ")));
  return fmt::format("{}", fmt::join(parts, ", "));
}

}  // namespace

std::vector<std::string> differing_settings(const std::vector<const RunRecord*>& runs) {
  std::vector<std::string> keys, sentences;
  std::vector<std::map<std::string, std::string>> settings;
  for (const RunRecord* run : runs) {
    if (!run->definition)
      return {
          fmt::format("The settings cannot be compared: {} has no case.toml that this program "
                      "understands.",
                      run->name)};
    const Settings all = settings_of(*run);
    for (const auto& [key, value] : all)
      if (std::find(keys.begin(), keys.end(), key) == keys.end()) keys.push_back(key);
    settings.emplace_back(all.begin(), all.end());
  }
  for (const std::string& key : keys) {
    const std::string values = values_text(runs, settings, key);
    if (!values.empty()) sentences.push_back(fmt::format("{}: {}.", key, values));
  }
  if (sentences.empty()) return {"The runs have the same settings."};
  if (sentences.size() > most_sentences) {
    const std::size_t more = sentences.size() - most_sentences;
    sentences.resize(most_sentences);
    sentences.push_back(fmt::format("They differ in {} more settings.", more));
  }
  return sentences;
}

}  // namespace washtub
