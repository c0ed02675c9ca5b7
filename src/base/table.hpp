#pragma once
#include <fmt/format.h>

#include <algorithm>
#include <functional>
#include <string>
#include <type_traits>
#include <vector>

#include "base/format.hpp"
#include "base/schema.hpp"

namespace washtub {

/// What the input reference and the JSON schema say of a key.
struct KeyText {
  std::string name, type, allowed, meaning, fallback;
  std::string schema{};   ///< of the value
  std::string value{};    ///< the default as TOML; "" where it depends on other keys
  bool required = false;  ///< in every case
};

/// Appends one section of the input reference in Markdown.
void document_keys(std::string& out, const std::string& heading, const std::string& meaning,
                   const std::vector<KeyText>& keys);

/// The table called `name` inside `table`, empty where the file does not give it.
Node table_in(const Node& table, const std::string& name);

/// Every entry of a list of tables; a single table counts as a list of one.
Node::List tables_in(const Node& table, const std::string& name);

/// How to do without a key: "; --set cloth.ripple= takes it out"; "" where --set itself gave it.
std::string take_out(const Node& value);

/// "cloth[2].count" -> "cloth.count".
std::string plain_key(const std::string& key);

/// @throws InputError naming the first member, in the order of the file, that no declared dotted
/// name covers, and the nearest declared one. A declared table of tables is looked into.
void check_known(const Node& table, const std::vector<std::string>& declared);

/// The declaration of a TOML table and of the struct T it fills. A key is declared once; reading,
/// errors, the resolved case and the input reference all come from that.
/// Reading leaves members whose key is absent as they are, so T's values are the defaults.
template <class T>
class Table {
 public:
  explicit Table(std::string meaning) : meaning_(std::move(meaning)) {}

  /// Declares a key; `access` is a pointer to a member of T or a function to a reference.
  template <class Access, class V>
  Table& key(const std::string& name, Access access, const Format<V>& format,
             const std::string& meaning) {
    Key key;
    key.text = {name, format.type, format.allowed, meaning, "", format.schema};
    key.read = [=](T& target, const Node& node, int dimension) {
      std::invoke(access, target) = format.read(node, dimension);
    };
    key.write = [=](const T& target, int dimension) {
      return format.write(std::invoke(access, const_cast<T&>(target)), dimension);
    };
    keys_.push_back(std::move(key));
    return *this;
  }
  using Test = std::function<bool(const T&, int dimension)>;
  /// The last key must be given, where it applies.
  Table& required() {
    keys_.back().text.required = true;
    return required([](const T&, int) { return true; });
  }
  /// The last key must be given where `missing` holds after reading.
  Table& required(Test missing) {
    keys_.back().missing = std::move(missing);
    return *this;
  }
  /// The last key may be given only where `applies` holds; `where` says it in words.
  Table& only(const std::string& where, Test applies) {
    keys_.back().where = where;
    keys_.back().applies = std::move(applies);
    return *this;
  }
  /// The last key is not written out where `unset` holds: its value stands for "none".
  Table& omitted(Test unset) {
    keys_.back().unset = std::move(unset);
    return *this;
  }
  /// What the reference says of the last key's default where that depends on other keys.
  Table& fallback(const std::string& words) {
    keys_.back().text.fallback = words;
    return *this;
  }

  /// Declares a table inside this one.
  template <class Access, class U>
  Table& table(const std::string& name, Access access, const Table<U>& inner) {
    Part part;
    part.name = name;
    part.read = [=](T& target, const Node& node, int dimension) {
      inner.read(std::invoke(access, target), table_in(node, name), dimension);
    };
    part.write = [=](std::string& out, const T& target, const std::string& path, int dimension) {
      out += fmt::format("\n[{}]\n", path);
      inner.write(out, std::invoke(access, const_cast<T&>(target)), path, dimension);
    };
    part.document = [=](std::string& out, const std::string& path) { inner.document(out, path); };
    part.names = inner.names();
    part.schema = {name, inner.schema(), inner.needed()};
    parts_.push_back(std::move(part));
    return *this;
  }
  /// Declares a list of tables; an entry starts as `prototype(T)` and is appended.
  template <class Access, class U>
  Table& list(const std::string& name, Access access, const Table<U>& inner,
              std::type_identity_t<std::function<U(const T&)>> prototype) {
    Part part;
    part.name = name;
    part.read = [=](T& target, const Node& node, int dimension) {
      for (const Node& entry : tables_in(node, name)) {
        U value = prototype(target);
        inner.read(value, entry, dimension);
        std::invoke(access, target).push_back(std::move(value));
      }
    };
    part.write = [=](std::string& out, const T& target, const std::string& path, int dimension) {
      for (const U& value : std::invoke(access, const_cast<T&>(target))) {
        out += fmt::format("\n[[{}]]\n", path);
        inner.write(out, value, path, dimension);
      }
    };
    part.document = [=](std::string& out, const std::string& path) { inner.document(out, path); };
    part.names = inner.names();
    part.schema = {name, json_schema::either(inner.schema(), json_schema::list(inner.schema()))};
    parts_.push_back(std::move(part));
    return *this;
  }
  /// The last table is read and written only where the file gives it or `present` holds.
  Table& optional(std::function<bool(const T&)> present, std::function<void(T&)> make) {
    Part& part = parts_.back();
    part.schema.required = false;
    part.read = [read = part.read, make, name = part.name](T& target, const Node& node, int dim) {
      if (!node.find(name)) return;
      make(target);
      read(target, node, dim);
    };
    part.write = [write = part.write, present](std::string& out, const T& target,
                                               const std::string& path, int dim) {
      if (present(target)) write(out, target, path, dim);
    };
    return *this;
  }
  /// Something to do after the parts declared so far were read and before the next ones are.
  Table& then(std::function<void(T&, const Node&, int dimension)> action) {
    Part part;
    part.read = std::move(action);
    parts_.push_back(std::move(part));
    return *this;
  }

  void read(T& target, const Node& node, int dimension) const {
    for (const Key& key : keys_)
      if (const Node* value = node.find(key.text.name)) key.read(target, *value, dimension);
    for (const Key& key : keys_) check(key, target, node, dimension);
    for (const Part& part : parts_) part.read(target, node, dimension);
  }
  /// `key = value` of every key that applies.
  std::vector<std::string> lines(const T& target, int dimension) const {
    std::vector<std::string> result;
    for (const Key& key : keys_) {
      if (key.applies && !key.applies(target, dimension)) continue;
      if (key.unset && key.unset(target, dimension)) continue;
      result.push_back(fmt::format("{} = {}", key.text.name, key.write(target, dimension)));
    }
    return result;
  }
  void write(std::string& out, const T& target, const std::string& path, int dimension) const {
    for (const std::string& line : lines(target, dimension)) out += line + '\n';
    for (const Part& part : parts_)
      if (part.write) part.write(out, target, join(path, part.name), dimension);
  }
  void document(std::string& out, const std::string& path) const {
    document_keys(out, path, meaning_, key_texts());
    for (const Part& part : parts_)
      if (part.document) part.document(out, join(path, part.name));
  }
  /// JSON schema of the table; `kind` as in Kinds.
  std::string schema(const std::string& kind = "") const {
    std::vector<json_schema::Part> parts;
    for (const Part& part : parts_)
      if (!part.name.empty()) parts.push_back(part.schema);
    return json_schema::table(meaning_, key_texts(), parts, kind);
  }
  /// Whether some key of the table or of one inside it must be given.
  bool needed() const {
    const auto texts = key_texts();
    return std::any_of(texts.begin(), texts.end(), [](auto& key) { return key.required; }) ||
           std::any_of(parts_.begin(), parts_.end(), [](auto& p) { return p.schema.required; });
  }
  /// Keys with default and where they apply, as the reference prints them.
  std::vector<KeyText> key_texts() const {
    std::vector<KeyText> texts;
    for (const Key& key : keys_) texts.push_back(key_text(key));
    return texts;
  }
  /// Dotted names of all keys, for check_known().
  std::vector<std::string> names() const {
    std::vector<std::string> result;
    for (const Key& key : keys_) result.push_back(key.text.name);
    for (const Part& part : parts_)
      for (const std::string& name : part.names) result.push_back(join(part.name, name));
    return result;
  }

 private:
  struct Key {
    KeyText text;
    std::string where;
    std::function<void(T&, const Node&, int)> read;
    std::function<std::string(const T&, int)> write;
    Test missing, applies, unset;
  };
  struct Part {
    std::string name;
    std::function<void(T&, const Node&, int)> read;
    std::function<void(std::string&, const T&, const std::string&, int)> write;
    std::function<void(std::string&, const std::string&)> document;
    std::vector<std::string> names;
    json_schema::Part schema;
  };

  static std::string join(const std::string& path, const std::string& name) {
    return path.empty() ? name : path + "." + name;
  }
  static void check(const Key& key, const T& target, const Node& node, int dimension) {
    const Node* value = node.find(key.text.name);
    const bool applies = !key.applies || key.applies(target, dimension);
    if (value && !applies) throw error_at(*value, "only " + key.where + take_out(*value));
    if (!value && applies && key.missing && key.missing(target, dimension))
      throw InputError(fmt::format("{}: missing key {}: {}, {}", node.where,
                                   join(node.key, key.text.name), key.text.type, key.text.meaning));
  }
  static KeyText key_text(const Key& key) {
    KeyText text = key.text;
    const T fresh{};
    const bool unset = key.unset && key.unset(fresh, 3);
    text.required = text.required && !key.applies;
    if (text.fallback.empty() && key.missing) text.fallback = "required";
    if (text.fallback.empty() && !unset) {
      text.value = key.write(fresh, 3);
      text.fallback = "`" + text.value + "`";
    }
    if (text.fallback.empty()) text.fallback = "none";
    if (!key.where.empty()) text.meaning += " (only " + key.where + ")";
    return text;
  }

  std::string meaning_;
  std::vector<Key> keys_;
  std::vector<Part> parts_;
};

}  // namespace washtub
