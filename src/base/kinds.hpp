#pragma once
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <functional>
#include <string>
#include <utility>
#include <vector>

#include "base/table.hpp"

namespace washtub {

/// A table whose key `kind` decides which other keys it has, and what is made of it; T has a member
/// `kind`, the text.
template <class T, class Made>
class Kinds {
 public:
  using Make = std::function<Made(const T&, int dimension)>;

  /// @param name  what the input reference and the JSON schema call it
  explicit Kinds(std::string name) : name_(std::move(name)) {}
  Kinds& kind(const std::string& name, Table<T> table, Make make) {
    kinds_.push_back({name, std::move(table), std::move(make)});
    return *this;
  }

  Made make(const T& value, int dimension) const { return find(value.kind).make(value, dimension); }

  /// Reads and writes the table in one line.
  Format<T> format() const {
    auto read = [self = *this](const Node& node, int dimension) {
      return self.read(node, dimension);
    };
    auto write = [self = *this](const T& value, int dimension) {
      const auto lines = self.find(value.kind).table.lines(value, dimension);
      const char* gap = lines.empty() ? "" : ", ";
      return fmt::format("{{ kind = \"{}\"{}{} }}", value.kind, gap, fmt::join(lines, ", "));
    };
    return {read, write, "table", fmt::format("`kind` one of {}", fmt::join(names(), ", ")),
            json_schema::reference(name_)};
  }

  /// The same where a table without `kind` changes `usual`, the default.
  Format<T> format(const T& usual) const {
    Format<T> result = format();
    result.read = [read = result.read, text = result.write(usual, 3)](const Node& node, int dim) {
      return read(node.is_table() && !node.find("kind") ? over(text, node) : node, dim);
    };
    result.allowed += "; without it, changes the default";
    return result;
  }

  T read(const Node& node, int dimension) const {
    if (!node.is_table())
      throw error_at(node, "expected a table such as { kind = \"" + kinds_.front().name + "\" }");
    const Node* kind = node.find("kind");
    if (!kind)
      throw error_at(node, fmt::format("missing key kind: one of {}", fmt::join(names(), ", ")));
    const Kind& chosen = kinds_[static_cast<size_t>(name_of(names()).read(*kind, dimension))];
    check_keys(node, *kind, chosen);
    T value;
    value.kind = chosen.name;
    chosen.table.read(value, node, dimension);
    return value;
  }

  void document(std::string& out) const {
    for (const Kind& kind : kinds_) kind.table.document(out, name_ + " " + kind.name);
  }
  /// Name and JSON schema, as the references of format() need them.
  std::pair<std::string, std::string> definition() const {
    std::vector<std::string> tables;
    for (const Kind& kind : kinds_) tables.push_back(kind.table.schema(kind.name));
    return {name_, json_schema::one_of(tables)};
  }

 private:
  struct Kind {
    std::string name;
    Table<T> table;
    Make make;

    bool has(const std::string& key) const {
      const auto keys = table.names();
      return std::find(keys.begin(), keys.end(), key) != keys.end();
    }
  };

  std::vector<std::string> names() const {
    std::vector<std::string> result;
    for (const Kind& kind : kinds_) result.push_back(kind.name);
    return result;
  }
  const Kind& find(const std::string& name) const {
    const auto hit = std::find_if(kinds_.begin(), kinds_.end(),
                                  [&](const Kind& kind) { return kind.name == name; });
    if (hit == kinds_.end()) throw InputError("no kind \"" + name + "\"");
    return *hit;
  }
  /// Refuses keys that only other kinds have, and those that none has.
  void check_keys(const Node& node, const Node& kind, const Kind& chosen) const {
    for (const auto& [key, member] : node.members()) {
      if (key == "kind" || chosen.has(key)) continue;
      for (const Kind& other : kinds_)
        if (other.has(key))
          throw error_at(member,
                         fmt::format("a key of kind \"{}\", but the kind is \"{}\" ({}); "
                                     "the whole table is replaced by --set '{}'",
                                     other.name, chosen.name, kind.where, example(node, chosen)));
    }
    const std::string path = plain_key(node.key);
    std::vector<std::string> known{path + ".kind"};
    for (const std::string& name : chosen.table.names()) known.push_back(path + "." + name);
    check_known(node, known);
  }
  /// The table with what it gives of the chosen kind's keys; "..." for what it would have to.
  static std::string example(const Node& node, const Kind& chosen) {
    std::string text = fmt::format("{}={{ kind = \"{}\"", node.key, chosen.name);
    for (const KeyText& key : chosen.table.key_texts()) {
      const Node* given = node.find(key.name);
      if (given || key.fallback == "required")
        text += fmt::format(", {} = {}", key.name, given ? value_text(*given) : "...");
    }
    return text + " }";
  }
  /// The table `text` with the members of `node` in place of its own.
  static Node over(const std::string& text, const Node& node) {
    Node whole = *parse_value(text, node.key);
    for (Node::Member& member : whole.members()) member.node.where = "the default";
    for (const Node::Member& member : node.members()) {
      if (Node* usual = whole.find(member.name))
        *usual = member.node;
      else
        whole.members().push_back(member);
    }
    whole.where = node.where;
    return whole;
  }

  std::string name_;
  std::vector<Kind> kinds_;
};

}  // namespace washtub
