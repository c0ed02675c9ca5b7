#pragma once
#include <cstdint>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "base/error.hpp"

namespace washtub {

/// One value of a case file, knowing where it was written.
struct Node {
  struct Member;
  using List = std::vector<Node>;
  using Members = std::vector<Member>;  ///< in order of appearance
  std::variant<std::monostate, bool, std::int64_t, double, std::string, List, Members> value;
  std::string where;  ///< "wash3d.toml:41", or "--set"
  std::string key;    ///< dotted name; entries of lists as in "cloth[2].count"

  bool is_table() const { return std::holds_alternative<Members>(value); }
  bool is_list() const { return std::holds_alternative<List>(value); }
  const Members& members() const { return std::get<Members>(value); }
  Members& members() { return std::get<Members>(value); }
  const List& list() const { return std::get<List>(value); }
  List& list() { return std::get<List>(value); }
  const Node* find(const std::string& name) const;  ///< member of a table; null where absent
  Node* find(const std::string& name);
};

struct Node::Member {
  std::string name;
  Node node;
};

constexpr std::size_t deepest = 64;  ///< tables and lists within each other, at most
std::string too_deep_text();         ///< what is said of more

/// Reads a TOML file into a table. @throws InputError with line and reason.
Node parse_file(const std::string& path);
/// The same of the text of a file called `name`.
Node parse_text(const std::string& text, const std::string& name);

/// A value as TOML, as if --set had given it; nothing where it is bare text such as `0.1 Pa s`.
std::optional<Node> parse_value(const std::string& text, const std::string& key);

/// Applies `key=value` as `--set` gives it: the value is TOML, or else taken as text; `key=` takes
/// the key out of the file. Tables of the key are made where absent; "cloth.count" reaches into a
/// list of one entry, and "cloth[2].count" into the second of several.
/// @throws InputError
void apply_setting(Node& root, const std::string& setting);

/// The member that a dotted key names; null where the file does not give it.
const Node* find_key(const Node& root, const std::string& key);

/// A text between quotes, as TOML reads it back.
std::string quoted(const std::string& text);

/// The value as TOML writes it: `"8e5 N"`, `[1, 2]`.
std::string value_text(const Node& node);

/// `wash3d.toml:41: cloth.stretch_stiffness = "8e5 N": <message>`; tables without their value.
InputError error_at(const Node& node, const std::string& message);

}  // namespace washtub
