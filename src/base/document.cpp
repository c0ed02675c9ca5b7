#include "base/document.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <toml++/toml.h>

#include <algorithm>
#include <cctype>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <optional>

#include "base/units.hpp"

namespace washtub {
namespace {

InputError too_deep(const std::string& where) {
  return InputError(fmt::format("{}: {}", where, too_deep_text()));
}

Node convert(const toml::node& from, const std::string& file, const std::string& key,
             std::size_t depth);

/// A dotted key; a name that is no bare word in TOML keeps its quotes, so that `"time.end"` is not
/// taken for `end` of the table `time`.
std::string join(const std::string& key, std::string_view name) {
  const bool bare = !name.empty() && std::all_of(name.begin(), name.end(), [](char c) {
    return std::isalnum(static_cast<unsigned char>(c)) || c == '_' || c == '-';
  });
  const std::string part = bare ? std::string(name) : quoted(std::string(name));
  return key.empty() ? part : fmt::format("{}.{}", key, part);
}

Node::Members convert_table(const toml::table& from, const std::string& file,
                            const std::string& key, std::size_t depth) {
  Node::Members members;
  for (const auto& [name, child] : from)
    members.push_back(
        {std::string(name.str()), convert(child, file, join(key, name.str()), depth)});
  std::stable_sort(members.begin(), members.end(), [&](const auto& a, const auto& b) {
    return from.get(a.name)->source().begin.line < from.get(b.name)->source().begin.line;
  });
  return members;
}

Node::List convert_array(const toml::array& from, const std::string& file, const std::string& key,
                         std::size_t depth) {
  const bool tables = from.is_array_of_tables();
  Node::List list;
  for (const auto& child : from) {
    const bool numbered = !tables || from.size() > 1;
    list.push_back(
        convert(child, file, numbered ? fmt::format("{}[{}]", key, list.size() + 1) : key, depth));
  }
  return list;
}

/// `file` empty: the value comes from the command line.
Node convert(const toml::node& from, const std::string& file, const std::string& key,
             std::size_t depth) {
  Node node;
  node.key = key;
  node.where = file.empty() ? "--set" : fmt::format("{}:{}", file, from.source().begin.line);
  if (depth > deepest) throw too_deep(node.where);
  if (const auto* table = from.as_table()) node.value = convert_table(*table, file, key, depth + 1);
  if (const auto* array = from.as_array()) node.value = convert_array(*array, file, key, depth + 1);
  if (const auto* flag = from.as_boolean()) node.value = flag->get();
  if (const auto* integer = from.as_integer()) node.value = integer->get();
  if (const auto* real = from.as_floating_point()) node.value = real->get();
  if (const auto* text = from.as_string()) node.value = text->get();
  return node;
}

/// The most dots of a key in a line.
std::size_t dots(std::string_view line) {
  std::size_t count = 0, most = 0;
  char quote = 0;
  for (std::size_t i = 0; i < line.size(); ++i) {
    const char c = line[i];
    if (quote == '"' && c == '\\') ++i;
    if (quote == 0 && c == '#') break;
    if (quote == 0 && std::string_view("=,[{").find(c) != std::string_view::npos) count = 0;
    if (quote == 0 && c == '.') most = std::max(most, ++count);
    if (quote == 0 ? c == '"' || c == '\'' : c == quote) quote = quote == 0 ? c : 0;
  }
  return most;
}

/// The parser of TOML bounds how deep values lie in each other, but not how many dots a key has.
void check_dots(std::string_view text, const std::string& name) {
  std::size_t line = 1;
  for (std::size_t begin = 0, end; begin < text.size(); begin = end + 1, ++line) {
    end = std::min(text.find('\n', begin), text.size());
    if (dots(text.substr(begin, end - begin)) > deepest)
      throw too_deep(name.empty() ? "--set" : fmt::format("{}:{}", name, line));
  }
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

std::string too_deep_text() {
  return fmt::format("tables and lists lie in each other more than {} deep; no case needs that",
                     deepest);
}

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
  check_dots(text, name);
  try {
    Node root = convert(toml::parse(text, name), name, "", 0);
    root.where = name;
    return root;
  } catch (const toml::parse_error& error) {
    throw InputError(
        fmt::format("{}:{}: {}", name, error.source().begin.line, error.description()));
  }
}

std::optional<Node> parse_value(const std::string& text, const std::string& key) {
  if (text.find('\n') != std::string::npos) return std::nullopt;
  check_dots(text, "");
  try {
    const toml::table table = toml::parse("value = " + text);
    Node node = convert(*table.get("value"), "", key, 0);
    if (std::holds_alternative<std::monostate>(node.value)) return std::nullopt;
    return node;
  } catch (const toml::parse_error&) {
    return std::nullopt;
  }
}

std::string quoted(const std::string& text) {
  std::string result = "\"";
  for (const char c : text) {
    const auto code = static_cast<unsigned char>(c);
    if (c == '"' || c == '\\') result += '\\';
    if (c == '\n')
      result += "\\n";
    else if (code < ' ' || code == 0x7f)
      result += fmt::format("\\u{:04X}", code);
    else
      result += c;
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
