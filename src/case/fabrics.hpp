#pragma once
#include <string>
#include <vector>

#include "base/document.hpp"

namespace washtub {

/// A value that a fabric gives a key of `[[cloth]]`, and where it comes from.
struct FabricValue {
  std::string key;
  Node value;          ///< as a case file writes it
  std::string source;  ///< "typical" where it was not measured
};

/// A kind of cloth, wet as in a wash.
struct Fabric {
  std::string name;
  std::vector<FabricValue> values;

  /// Of the key as TOML; "" where the fabric does not give it.
  std::string text(const std::string& key) const;
};

const std::vector<Fabric>& fabrics();
std::vector<std::string> fabric_names();

/// One line per fabric in Markdown.
std::string fabric_reference();
/// What the fabric gives `[[cloth]]`, as TOML with the sources.
std::string fabric_text(const Fabric& fabric);

/// Fills in what fabric and readings (KES, FAST) of each `[[cloth]]` say of keys that the file does
/// not give.
/// @throws InputError for a fabric that does not exist, or a reading out of range
void use_fabrics(Node& root, int dimension);

}  // namespace washtub
