#include "base/schema.hpp"

#include <cmath>
#include <nlohmann/json.hpp>

#include "base/table.hpp"

namespace washtub {
namespace {

using Json = nlohmann::ordered_json;

Json to_json(const Node& node) {
  if (node.is_list()) {
    Json list = Json::array();
    for (const Node& entry : node.list()) list.push_back(to_json(entry));
    return list;
  }
  if (node.is_table()) {
    Json table = Json::object();
    for (const auto& [name, member] : node.members()) table[name] = to_json(member);
    return table;
  }
  if (const auto* flag = std::get_if<bool>(&node.value)) return *flag;
  if (const auto* whole = std::get_if<std::int64_t>(&node.value)) return *whole;
  if (const auto* real = std::get_if<double>(&node.value)) return *real;
  return std::get<std::string>(node.value);
}

/// A value as TOML writes it.
Json parse_toml(const std::string& value) {
  Node root{Node::Members{}, "", ""};
  apply_setting(root, "value=" + value);
  return to_json(*root.find("value"));
}

Json bounded(const char* type, const Range& range) {
  Json json = {{"type", type}};
  if (!std::isinf(range.least)) json["minimum"] = range.least;
  if (range.least_excluded) json["exclusiveMinimum"] = true;
  if (!std::isinf(range.most)) json["maximum"] = range.most;
  return json;
}

std::string describe(const KeyText& key) {
  std::string text = key.meaning + ": " + key.type;
  if (!key.allowed.empty()) text += ", " + key.allowed;
  if (!key.value.empty() || key.required) return text;
  return text + (key.fallback.starts_with("required") ? "; " : "; default: ") + key.fallback;
}

Json key_schema(const KeyText& key) {
  Json json = Json::parse(key.schema);
  if (json.contains("$ref"))
    json = {{"allOf", Json::array({json})}};  // whose neighbours would be ignored
  json["description"] = describe(key);
  if (!key.value.empty()) json["default"] = parse_toml(key.value);
  return json;
}

}  // namespace

namespace json_schema {

std::string text(const std::string& pattern) {
  Json json = {{"type", "string"}};
  if (!pattern.empty()) json["pattern"] = pattern;
  return json.dump();
}

std::string quantity(const Measure& measure) {
  const std::string number = "[+-]?([0-9]+[.]?[0-9]*|[.][0-9]+)([eE][+-]?[0-9]+)?";
  // Not the exponent of a number without unit; may begin as "1/s" does.
  const std::string unit = "[0-9./ \t]*([A-DF-Za-df-z\u00b5\u03bc\u00b0%'\"]|[eE][A-Za-z]).*";
  Json json = Json::parse(text("^[ \t]*" + number + "[ \t]*" + unit + "$"));
  json["title"] = std::string(measure.name) + " such as \"" + measure.example + '"';
  return json.dump();
}

std::string number(const Range& range) { return bounded("number", range).dump(); }
std::string integer(const Range& range) { return bounded("integer", range).dump(); }
std::string boolean() { return R"({"type":"boolean"})"; }
std::string names(const std::vector<std::string>& names) { return Json{{"enum", names}}.dump(); }

std::string list(const std::string& entry, size_t least) {
  return Json{{"type", "array"}, {"items", Json::parse(entry)}, {"minItems", least}}.dump();
}

std::string list(const std::string& entry, size_t least, size_t most) {
  Json json = Json::parse(list(entry, least));
  json["maxItems"] = most;
  return json.dump();
}

std::string either(const std::string& one, const std::string& other) {
  return Json{{"anyOf", Json::array({Json::parse(one), Json::parse(other)})}}.dump();
}

std::string reference(const std::string& definition) {
  return Json{{"$ref", "#/definitions/" + definition}}.dump();
}

std::string table(const std::string& meaning, const std::vector<KeyText>& keys,
                  const std::vector<Part>& parts, const std::string& kind) {
  Json properties = Json::object(), required = Json::array();
  if (!kind.empty()) {
    properties["kind"] = {{"enum", Json::array({kind})}};
    required.push_back("kind");
  }
  for (const KeyText& key : keys) {
    properties[key.name] = key_schema(key);
    if (key.required) required.push_back(key.name);
  }
  for (const Part& part : parts) {
    properties[part.name] = Json::parse(part.schema);
    if (part.required) required.push_back(part.name);
  }
  Json json = {{"type", "object"},
               {"description", meaning},
               {"properties", properties},
               {"additionalProperties", false}};
  if (!required.empty()) json["required"] = required;  // draft 4 wants one at least
  return json.dump();
}

std::string one_of(const std::vector<std::string>& tables) {
  Json options = Json::array();
  for (const std::string& table : tables) options.push_back(Json::parse(table));
  return Json{{"oneOf", options}}.dump();
}

std::string document(const std::string& root,
                     const std::vector<std::pair<std::string, std::string>>& definitions) {
  Json json = {{"$schema", "http://json-schema.org/draft-04/schema#"},
               {"title", "Case file of Washtub"}};
  json.update(Json::parse(root));
  for (const auto& [name, definition] : definitions)
    json["definitions"][name] = Json::parse(definition);
  return json.dump(2) + '\n';
}

}  // namespace json_schema
}  // namespace washtub
