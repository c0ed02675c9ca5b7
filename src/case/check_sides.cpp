#include <cmath>

#include "case/tables.hpp"

namespace washtub {
namespace {

std::string side_key(size_t side) {
  static constexpr const char* names[] = {"x_lower", "x_upper", "y_lower",
                                          "y_upper", "z_lower", "z_upper"};
  return std::string("domain.sides.") + names[side];
}

void check_pair(const Case& whole, const Node& root, size_t axis) {
  const bool lower = whole.domain.sides[2 * axis].kind == SideKind::periodic;
  const bool upper = whole.domain.sides[2 * axis + 1].kind == SideKind::periodic;
  if (lower != upper)
    throw error_at_key(root, side_key(2 * axis + (lower ? 0 : 1)), "",
                       "periodic sides come in pairs, so the opposite side must be periodic too");
}

/// Speed at which the water of a side enters the box [m/s].
double entry(const Case& whole, size_t side) {
  const SideCase& s = whole.domain.sides[side];
  const double along = s.velocity[static_cast<int>(side / 2)];
  return side % 2 == 0 ? along : -along;
}

void check_velocity(const Case& whole, const Node& root, size_t side) {
  const std::string key = side_key(side) + "_velocity";
  const SideKind kind = whole.domain.sides[side].kind;
  if (kind == SideKind::moving_wall && entry(whole, side) != 0)
    throw error_at_key(root, key, "", "a wall can only move along itself");
  if (kind == SideKind::inflow && entry(whole, side) <= 0)
    throw error_at_key(root, key, "", "the water of an inflow must enter the box");
}

/// What enters must be able to leave.
void check_balance(const Case& whole, const Node& root) {
  const auto sides = 2 * static_cast<size_t>(whole.dimension);
  size_t first = sides;
  for (size_t side = 0; side < sides; ++side) {
    const SideKind kind = whole.domain.sides[side].kind;
    if (kind == SideKind::outflow || kind == SideKind::far_field) return;
    if (kind == SideKind::inflow && first == sides) first = side;
  }
  if (first < sides)
    throw error_at_key(root, side_key(first), "",
                       "the water that enters cannot leave; make another side \"outflow\"");
}

}  // namespace

void check_sides(const Case& whole, const Node& root) {
  for (size_t axis = 0; axis < static_cast<size_t>(whole.dimension); ++axis) {
    check_pair(whole, root, axis);
    check_velocity(whole, root, 2 * axis);
    check_velocity(whole, root, 2 * axis + 1);
  }
  check_balance(whole, root);
}

}  // namespace washtub
