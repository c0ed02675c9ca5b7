#include "base/table.hpp"

#include <algorithm>

#include "base/nearest.hpp"

namespace washtub {
namespace {

std::string leaf(const std::string& key) { return key.substr(key.rfind('.') + 1); }

/// The declared name most like `key`, as a whole or, in another table, by its last part.
std::string nearest_key(const std::string& key, const std::vector<std::string>& declared) {
  const std::string whole = nearest_name(key, declared);
  int least = whole.empty() ? 1000 : edit_distance(key, whole);
  std::string best = whole;
  for (const std::string& name : declared) {
    const int distance = edit_distance(leaf(key), leaf(name)) + 1;
    if (distance >= least || distance > static_cast<int>(leaf(key).size()) / 2) continue;
    least = distance;
    best = name;
  }
  return best;
}

bool covers_table(const std::string& key, const std::vector<std::string>& declared) {
  return std::any_of(declared.begin(), declared.end(),
                     [&](const std::string& name) { return name.starts_with(key + "."); });
}

void check_member(const Node& member, const std::vector<std::string>& declared) {
  const std::string key = plain_key(member.key);
  if (std::find(declared.begin(), declared.end(), key) != declared.end()) return;
  if (!covers_table(key, declared)) {
    const std::string nearest = nearest_key(key, declared);
    throw error_at(member, nearest.empty() ? "unknown key; `washtub reference` lists all"
                                           : "unknown key, nearest known: " + nearest);
  }
  if (member.is_table()) return check_known(member, declared);
  if (!member.is_list()) throw error_at(member, "expected a table");
  for (const Node& entry : member.list()) {
    if (!entry.is_table()) throw error_at(entry, "expected a table");
    check_known(entry, declared);
  }
}

}  // namespace

std::string take_out(const Node& value) {
  return value.where == "--set" ? "" : "; --set " + value.key + "= takes it out";
}

std::string plain_key(const std::string& key) {
  std::string plain;
  bool inside = false;
  for (const char c : key) {
    if (c == '[') inside = true;
    if (!inside) plain += c;
    if (c == ']') inside = false;
  }
  return plain;
}

namespace {

/// A text in a cell of a Markdown table, whose bars would end it.
std::string cell(const std::string& text) {
  std::string out;
  for (const char letter : text) (letter == '|' ? out += '\\' : out) += letter;
  return out;
}

}  // namespace

void document_keys(std::string& out, const std::string& heading, const std::string& meaning,
                   const std::vector<KeyText>& keys) {
  out +=
      fmt::format("\n## {}\n\n{}\n", heading.empty() ? "Top level" : "`" + heading + "`", meaning);
  if (keys.empty()) return;
  out += "\n| key | value | default | allowed | meaning |\n|---|---|---|---|---|\n";
  for (const KeyText& key : keys)
    out += fmt::format("| `{}` | {} | {} | {} | {} |\n", key.name, key.type, cell(key.fallback),
                       cell(key.allowed), cell(key.meaning));
}

Node table_in(const Node& table, const std::string& name) {
  if (const Node* found = table.find(name)) {
    if (found->is_list() && found->list().size() == 1) return found->list().front();
    if (!found->is_table()) throw error_at(*found, "expected one table");
    return *found;
  }
  return {Node::Members{}, table.where, table.key.empty() ? name : table.key + "." + name};
}

Node::List tables_in(const Node& table, const std::string& name) {
  const Node* found = table.find(name);
  if (!found) return {};
  return found->is_list() ? found->list() : Node::List{*found};
}

void check_known(const Node& table, const std::vector<std::string>& declared) {
  for (const auto& [name, member] : table.members()) check_member(member, declared);
}

}  // namespace washtub
