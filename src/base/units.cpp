#include "base/units.hpp"

#include <fmt/format.h>
#include <udunits2.h>

#include <array>
#include <charconv>
#include <cmath>
#include <filesystem>
#include <memory>

#include "base/error.hpp"

namespace washtub {
namespace {

struct FreeUnit {
  void operator()(ut_unit* unit) const { ut_free(unit); }
};
using Unit = std::unique_ptr<ut_unit, FreeUnit>;

/// The units database: where UDUNITS2_XML_PATH says, where the library was built for, or where
/// distributions put it.
ut_system* load_database() {
  ut_set_error_message_handler(ut_ignore);
  if (ut_system* system = ut_read_xml(nullptr)) return system;
  for (const char* path :
       {"/usr/share/xml/udunits/udunits2.xml", "/usr/share/udunits/udunits2.xml",
        "/usr/local/share/udunits/udunits2.xml", "/opt/local/share/udunits/udunits2.xml"}) {
    if (!std::filesystem::exists(path)) continue;
    if (ut_system* system = ut_read_xml(path)) return system;
  }
  throw InputError(
      "the units database udunits2.xml was not found; install libudunits2-data or let "
      "UDUNITS2_XML_PATH name it");
}

ut_system* database() {
  static ut_system* const system = [] {
    ut_system* loaded = load_database();
    const Unit degree(ut_parse(loaded, "arc_degree", UT_ASCII));
    ut_map_name_to_unit("deg", UT_ASCII, degree.get());
    return loaded;
  }();
  return system;
}

Unit parse_unit(std::string_view text) {
  return Unit(ut_parse(database(), std::string(text).c_str(), UT_UTF8));
}

/// Whether the unit's definition contains the radian, which UDUNITS itself ignores.
bool counts_angle(const ut_unit* unit) {
  std::array<char, 256> text{};
  ut_format(unit, text.data(), text.size() - 1, UT_ASCII | UT_DEFINITION);
  return std::string_view(text.data()).find("rad") != std::string_view::npos;
}

std::string_view trimmed(std::string_view text) {
  const auto first = text.find_first_not_of(" \t");
  if (first == std::string_view::npos) return {};
  return text.substr(first, text.find_last_not_of(" \t") - first + 1);
}

[[noreturn]] void refuse(const Measure& expected) {
  throw InputError(fmt::format("expected {} such as \"{}\"", expected.name, expected.example));
}

/// Divides where the factor is one over a whole number, so that 23.76 cm is 0.2376 m to the last
/// bit.
double convert(double value, const ut_unit* from, const Measure& expected) {
  const Unit target = parse_unit(expected.unit);
  const Unit ratio(ut_divide(from, target.get()));  // UDUNITS would turn metres into 1/m
  if (!ratio || !ut_is_dimensionless(ratio.get())) refuse(expected);
  if (counts_angle(from) != counts_angle(target.get())) refuse(expected);
  const std::unique_ptr<cv_converter, void (*)(cv_converter*)> converter(
      ut_get_converter(const_cast<ut_unit*>(from), target.get()), cv_free);
  if (!converter) refuse(expected);
  const double factor = cv_convert_double(converter.get(), 1.0);
  const double inverse = std::round(1 / factor);
  const bool divides = inverse > 1 && std::abs(factor * inverse - 1) < 1e-15;
  return divides ? value / inverse : cv_convert_double(converter.get(), value);
}

}  // namespace

double parse_quantity(std::string_view text, const Measure& expected) {
  text = trimmed(text);
  if (text.starts_with('+')) text.remove_prefix(1);
  double value = 0;
  const auto [end, code] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (code != std::errc() || !std::isfinite(value)) refuse(expected);
  const std::string_view unit_name = trimmed(text.substr(static_cast<size_t>(end - text.data())));
  if (unit_name.empty()) refuse(expected);
  const Unit unit = parse_unit(unit_name);
  if (!unit)
    throw InputError(fmt::format("unknown unit \"{}\", expected {} such as \"{}\"", unit_name,
                                 expected.name, expected.example));
  const double result = convert(value, unit.get(), expected);
  if (!(std::abs(result) <= largest_quantity))
    throw InputError(
        fmt::format("expected {} up to {:g} {}", expected.name, largest_quantity, expected.unit));
  return result;
}

std::string quantity_text(double value, const Measure& measure) {
  return fmt::format("{} {}", value == 0 ? 0.0 : value, measure.unit);
}

std::string number_text(double value) {
  std::string text = fmt::format("{}", value == 0 ? 0.0 : value);
  if (text.find_first_of(".enif") == std::string::npos) text += ".0";
  return text;
}

}  // namespace washtub
