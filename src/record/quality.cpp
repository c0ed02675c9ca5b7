#include "record/quality.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace washtub {
namespace {

constexpr double rest_bound = 0.2;        // of the work, found nowhere
constexpr double crossings_bound = 0.01;  // of the edges

}  // namespace

bool is_closed(const Case& whole) {
  return std::none_of(whole.domain.sides.begin(), whole.domain.sides.end(), [](const SideCase& s) {
    return s.kind == SideKind::inflow || s.kind == SideKind::outflow ||
           s.kind == SideKind::far_field;
  });
}

std::vector<std::string> Quality::warnings(const Case& whole) const {
  std::vector<std::string> found;
  if (!start.empty()) found.push_back(start);
  if (const auto text = unresolved(worst, whole))
    found.push_back(*text);
  else if (const auto foreseen = foresee_unresolved(whole))
    found.push_back(*foreseen);
  if (is_closed(whole) && balance.share() < -rest_bound)
    found.push_back(fmt::format(
        "The scheme put energy into the motion: {:.2g} % of the work or the heat, whichever is "
        "larger (below {:.0f} % is good); try {}.",
        -100 * balance.share(), 100 * rest_bound,
        whole.coupling.scheme == Scheme::explicit_euler && !whole.cloth.empty()
            ? "coupling.scheme = \"implicit\""
            : fmt::format("more domain.cells or a smaller time.{}",
                          whole.time.fixed ? "step" : "cfl")));
  const double allowed = whole.contact.scheme == ContactScheme::none ? crossings_bound : 0;
  if (static_cast<double>(most_crossings) > allowed * static_cast<double>(crossings.edges))
    found.push_back(fmt::format(
        "Cloth passes through other cloth: up to {} of {} edges ({:.2g} %) in a frame. {}.",
        most_crossings, crossings.edges,
        100 * static_cast<double>(most_crossings) / static_cast<double>(crossings.edges),
        whole.contact.scheme == ContactScheme::none
            ? "Nothing holds pieces apart but the water between them; try contact.scheme = "
              "\"layers\""
            : "Contact keeps apart what is not tangled when it starts; else this is a fault"));
  return found;
}

void Quality::state(Archive& archive) {
  archive.value("worst resolution", worst);
  archive.value("energy balance", balance);
  archive.value("edges", crossings.edges);
  archive.value("crossings of others", crossings.others);
  archive.value("crossings of its own", crossings.own);
  archive.value("most crossings", most_crossings);
  archive.value("most crossings of its own", most_own_crossings);
  archive.value("gap", gap);
  archive.value("own gap", own_gap);
  archive.value("still near a quarter later", still_near[0]);
  archive.value("still near a period later", still_near[1]);
  archive.value("start", start);
}

}  // namespace washtub
