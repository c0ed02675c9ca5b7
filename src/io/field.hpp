#pragma once
#include <span>
#include <string>
#include <vector>

namespace washtub {

/// What one field of the frames is: the one place where writer, index, reader and pages know it
/// from. It is stored beside the values.
struct FieldDescription {
  std::string name;     ///< of its dataset: "solid"
  std::string label;    ///< as ParaView shows it, before its unit: "solid fraction"
  std::string unit;     ///< "" for a pure number
  int components = 1;   ///< 1 or 3
  std::string meaning;  ///< in a few words
  bool operator==(const FieldDescription&) const = default;
};

/// "pressure [Pa]", "solid fraction".
inline std::string heading(const FieldDescription& field) {
  return field.unit.empty() ? field.label : field.label + " [" + field.unit + "]";
}

/// Values of a field in some cells; those of a vector one after the other.
struct FieldBlock {
  FieldDescription field;
  std::span<const float> values;
};

/// All of a field that a frame has.
template <class T>
struct FieldValues {
  FieldDescription field;
  std::vector<T> values;
};

/// The values of the field with that name; null where there is none.
template <class T>
const std::vector<T>* find(const std::vector<FieldValues<T>>& fields, const std::string& name) {
  for (const FieldValues<T>& one : fields)
    if (one.field.name == name) return &one.values;
  return nullptr;
}

}  // namespace washtub
