#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <optional>
#include <sstream>

#include "base/document.hpp"

namespace washtub {
namespace {

std::string join(const std::string& key, const std::string& name) {
  return key.empty() ? name : fmt::format("{}.{}", key, name);
}

struct Step {
  std::string name;
  std::optional<size_t> entry;  ///< 1 for the first of a list
};

/// "cloth[2]" -> cloth, 2.
Step read_step(const std::string& part) {
  const auto bracket = part.find('[');
  if (bracket == std::string::npos) return {part, {}};
  size_t entry = 0;
  const char* const last = part.data() + part.size();
  const auto [end, code] = std::from_chars(part.data() + bracket + 1, last, entry);
  if (code != std::errc() || end + 1 != last || *end != ']' || entry == 0)
    throw InputError(fmt::format("{}: expected a number from 1 between the brackets, as in {}[1]",
                                 part, part.substr(0, bracket)));
  return {part.substr(0, bracket), entry};
}

/// "cloth[2].count" -> cloth (2), count.
std::vector<Step> split(const std::string& key) {
  std::vector<Step> steps;
  std::stringstream stream(key);
  for (std::string part; std::getline(stream, part, '.');) steps.push_back(read_step(part));
  return steps;
}

/// The table a step leads to: the member itself, or an entry of a list.
Node& enter(Node& node, const Step& step) {
  const size_t count = node.is_list() ? node.list().size() : 1;
  const size_t entry = step.entry.value_or(count == 1 ? 1 : 0);
  if (entry < 1 || entry > count)
    throw InputError(count == 1
                         ? fmt::format("there is one {0}, name it as {0} or {0}[1]", step.name)
                         : fmt::format("there are {0} of {1}, name one of {1}[1] to {1}[{0}]",
                                       count, step.name));
  return node.is_list() ? node.list()[entry - 1] : node;
}

/// Puts a value in its place, or takes out what is there.
void set_member(Node& table, const std::string& name, std::optional<Node> value) {
  auto& members = table.members();
  const auto old = std::find_if(members.begin(), members.end(),
                                [&](const auto& member) { return member.name == name; });
  if (old == members.end()) {
    if (!value) throw InputError("the case file does not give it, so it cannot be taken out");
    members.push_back({name, std::move(*value)});
  } else if (value) {
    old->node = std::move(*value);
  } else {
    members.erase(old);
  }
}

/// The same for one entry of a list.
void set_entry(Node& table, const Step& step, std::optional<Node> value) {
  Node* list = table.find(step.name);
  if (!list || !list->is_list()) throw InputError(step.name + " is no list in the case file");
  Node& entry = enter(*list, step);
  if (value) {
    entry = std::move(*value);
  } else {
    list->list().erase(list->list().begin() + (&entry - list->list().data()));
  }
}

Node empty_table(const std::string& key) { return {Node::Members{}, "--set", key}; }

/// TOML, or else the text as it is.
Node value_of(const std::string& text, const std::string& key) {
  if (const auto value = parse_value(text, key)) return *value;
  if (const auto value = parse_value(quoted(text), key)) return *value;
  throw InputError("the value is no text in UTF-8");
}

void apply(Node& root, const std::string& key, const std::string& text) {
  const std::vector<Step> steps = split(key);
  if (steps.size() > deepest) throw InputError(too_deep_text());
  Node* table = &root;
  for (size_t i = 0; i + 1 < steps.size(); ++i) {
    if (!table->find(steps[i].name))
      set_member(*table, steps[i].name, empty_table(join(table->key, steps[i].name)));
    table = &enter(*table->find(steps[i].name), steps[i]);
    if (!table->is_table())
      throw InputError(fmt::format("{} = {} is no table", table->key, value_text(*table)));
  }
  const Step& last = steps.back();
  std::string full_key = join(table->key, last.name);
  if (last.entry) full_key += fmt::format("[{}]", *last.entry);
  std::optional<Node> value;
  if (!text.empty()) value = value_of(text, full_key);
  if (last.entry) return set_entry(*table, last, std::move(value));
  set_member(*table, last.name, std::move(value));
}

}  // namespace

void apply_setting(Node& root, const std::string& setting) {
  const auto equals = setting.find('=');
  if (equals == std::string::npos || equals == 0)
    throw InputError(fmt::format("--set {}: expected key=value such as cloth.count=32", setting));
  try {
    apply(root, setting.substr(0, equals), setting.substr(equals + 1));
  } catch (const InputError& error) {
    throw InputError(fmt::format("--set {}: {}", setting, error.what()));
  }
}

const Node* find_key(const Node& root, const std::string& key) {
  const Node* node = &root;
  for (const Step& step : split(key)) {
    if (node->is_list() && node->list().size() == 1) node = &node->list()[0];
    node = node->find(step.name);
    if (node && node->is_list() && step.entry)
      node = *step.entry <= node->list().size() ? &node->list()[*step.entry - 1] : nullptr;
    if (!node) return nullptr;
  }
  return node;
}

}  // namespace washtub
