#include "base/document.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <toml++/toml.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <optional>

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
