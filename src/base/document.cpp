#include "base/document.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <toml++/toml.h>

#include <algorithm>
#include <charconv>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <optional>
#include <sstream>

#include "base/units.hpp"

namespace washtub {
namespace {

Node convert(const toml::node& from, const std::string& file, const std::string& key);

std::string join(const std::string& key, std::string_view name) {
  return key.empty() ? std::string(name) : fmt::format("{}.{}", key, name);
}

Node::Members convert_table(const toml::table& from, const std::string& file,
                            const std::string& key) {
  Node::Members members;
  for (const auto& [name, child] : from)
    members.push_back({std::string(name.str()), convert(child, file, join(key, name.str()))});
  std::stable_sort(members.begin(), members.end(), [&](const auto& a, const auto& b) {
    return from.get(a.name)->source().begin.line < from.get(b.name)->source().begin.line;
  });
  return members;
}

Node::List convert_array(const toml::array& from, const std::string& file, const std::string& key) {
  const bool tables = from.is_array_of_tables();
  Node::List list;
  for (const auto& child : from) {
    const bool numbered = !tables || from.size() > 1;
    list.push_back(
        convert(child, file, numbered ? fmt::format("{}[{}]", key, list.size() + 1) : key));
  }
  return list;
}

/// `file` empty: the value comes from the command line.
Node convert(const toml::node& from, const std::string& file, const std::string& key) {
  Node node;
  node.key = key;
  node.where = file.empty() ? "--set" : fmt::format("{}:{}", file, from.source().begin.line);
  if (const auto* table = from.as_table()) node.value = convert_table(*table, file, key);
  if (const auto* array = from.as_array()) node.value = convert_array(*array, file, key);
  if (const auto* flag = from.as_boolean()) node.value = flag->get();
  if (const auto* integer = from.as_integer()) node.value = integer->get();
  if (const auto* real = from.as_floating_point()) node.value = real->get();
  if (const auto* text = from.as_string()) node.value = text->get();
  return node;
}

std::string read_text(const std::string& path) {
  if (!std::filesystem::exists(path)) throw InputError(fmt::format("{}: no such file", path));
  if (std::filesystem::is_directory(path))
    throw InputError(fmt::format("{}: is a directory, expected a case file", path));
  std::ifstream file(path, std::ios::binary);
  if (!file) throw InputError(fmt::format("{}: cannot be read", path));
  return {std::istreambuf_iterator<char>(file), std::istreambuf_iterator<char>()};
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

}  // namespace

const Node* Node::find(const std::string& name) const {
  if (!is_table()) return nullptr;
  const auto hit = std::find_if(members().begin(), members().end(),
                                [&](const auto& member) { return member.name == name; });
  return hit == members().end() ? nullptr : &hit->node;
}

Node* Node::find(const std::string& name) {
  return const_cast<Node*>(static_cast<const Node*>(this)->find(name));
}

Node parse_file(const std::string& path) { return parse_text(read_text(path), path); }

Node parse_text(const std::string& text, const std::string& name) {
  try {
    Node root = convert(toml::parse(text, name), name, "");
    root.where = name;
    return root;
  } catch (const toml::parse_error& error) {
    throw InputError(
        fmt::format("{}:{}: {}", name, error.source().begin.line, error.description()));
  }
}

std::optional<Node> parse_value(const std::string& text, const std::string& key) {
  if (text.find('\n') != std::string::npos) return std::nullopt;
  try {
    const toml::table table = toml::parse("value = " + text);
    Node node = convert(*table.get("value"), "", key);
    if (std::holds_alternative<std::monostate>(node.value)) return std::nullopt;
    return node;
  } catch (const toml::parse_error&) {
    return std::nullopt;
  }
}

namespace {

void apply(Node& root, const std::string& key, const std::string& text) {
  const std::vector<Step> steps = split(key);
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
  if (!text.empty()) value = parse_value(text, full_key).value_or(Node{text, "--set", full_key});
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

std::string quoted(const std::string& text) {
  std::string result = "\"";
  for (const char c : text) {
    if (c == '"' || c == '\\') result += '\\';
    if (c == '\n') {
      result += "\\n";
    } else {
      result += c;
    }
  }
  return result + '"';
}

std::string value_text(const Node& node) {
  struct Text {
    std::string operator()(std::monostate) const { return "?"; }
    std::string operator()(bool flag) const { return flag ? "true" : "false"; }
    std::string operator()(std::int64_t integer) const { return fmt::format("{}", integer); }
    std::string operator()(double real) const { return number_text(real); }
    std::string operator()(const std::string& text) const { return quoted(text); }
    std::string operator()(const Node::Members&) const { return "{...}"; }
    std::string operator()(const Node::List& list) const {
      std::vector<std::string> texts;
      for (const Node& entry : list) texts.push_back(value_text(entry));
      return fmt::format("[{}]", fmt::join(texts, ", "));
    }
  };
  return std::visit(Text{}, node.value);
}

InputError error_at(const Node& node, const std::string& message) {
  const char* gap = node.where == "--set" ? " " : ": ";
  const bool tables =
      node.is_table() || (node.is_list() && !node.list().empty() && node.list().front().is_table());
  if (node.key.empty()) return InputError(fmt::format("{}: {}", node.where, message));
  if (tables) return InputError(fmt::format("{}{}{}: {}", node.where, gap, node.key, message));
  return InputError(
      fmt::format("{}{}{} = {}: {}", node.where, gap, node.key, value_text(node), message));
}

}  // namespace washtub
