#pragma once
#include <string>
#include <utility>
#include <vector>

#include "base/units.hpp"

namespace washtub {

struct KeyText;
struct Range;

/// JSON schemas of what a case file may hold, each the text of a JSON value, for editors that
/// complete and check TOML. Of draft 4, the latest that Taplo and Even Better TOML know.
namespace json_schema {

std::string text(const std::string& pattern = "");
std::string quantity(const Measure& measure);  ///< a text that begins with a number, then a unit
std::string number(const Range& range);
std::string integer(const Range& range);
std::string boolean();
std::string names(const std::vector<std::string>& names);  ///< one of these
std::string list(const std::string& entry, size_t least = 0);
std::string list(const std::string& entry, size_t least, size_t most);
std::string either(const std::string& one, const std::string& other);
std::string reference(const std::string& definition);

/// A table inside another one, under its name there.
struct Part {
  std::string name, schema;
  bool required = false;
};
/// A table with these keys and no others; `kind` is the value of its key `kind`, "" if it has none.
std::string table(const std::string& meaning, const std::vector<KeyText>& keys,
                  const std::vector<Part>& parts, const std::string& kind = "");
/// One of several tables.
std::string one_of(const std::vector<std::string>& tables);

/// The whole schema, with what its references name, ready to be printed.
std::string document(const std::string& root,
                     const std::vector<std::pair<std::string, std::string>>& definitions);

}  // namespace json_schema
}  // namespace washtub
