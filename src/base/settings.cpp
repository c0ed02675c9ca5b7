#include "base/settings.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <map>

namespace washtub {
namespace {

void flatten(const Node& node, Settings& settings) {
  const bool tables = node.is_list() && !node.list().empty() && node.list()[0].is_table();
  if (node.is_table())
    for (const Node::Member& member : node.members()) flatten(member.node, settings);
  else if (tables)
    for (const Node& entry : node.list()) flatten(entry, settings);
  else
    settings.emplace_back(node.key, value_text(node));
}

}  // namespace

Settings settings_of(const Node& root) {
  Settings settings;
  flatten(root, settings);
  return settings;
}

std::vector<std::string> differences(const Settings& there, const Settings& here) {
  const std::map<std::string, std::string> mine(here.begin(), here.end());
  const std::map<std::string, std::string> theirs(there.begin(), there.end());
  std::vector<std::string> sentences;
  for (const auto& [key, value] : there) {
    const auto found = mine.find(key);
    if (found == mine.end())
      sentences.push_back(fmt::format("{} = {}, here not set", key, value));
    else if (found->second != value)
      sentences.push_back(fmt::format("{} = {}, here {}", key, value, found->second));
  }
  for (const auto& [key, value] : here)
    if (!theirs.contains(key)) sentences.push_back(fmt::format("{} not set, here {}", key, value));
  return sentences;
}

}  // namespace washtub
