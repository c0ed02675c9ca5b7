#include <cmath>

#include "case/tables.hpp"

namespace washtub {
namespace {

bool is_book(const ClothCase& cloth, int) { return cloth.arrangement == Arrangement::book; }
bool is_sheet(const ClothCase& cloth, int) { return cloth.arrangement == Arrangement::sheet; }
bool is_ring(const ClothCase& cloth, int) { return cloth.arrangement == Arrangement::ring; }
bool is_rippled(const ClothCase& cloth, int dimension) {
  return is_sheet(cloth, dimension) || is_ring(cloth, dimension);
}
bool is_placed(const ClothCase& cloth, int dimension) { return !is_rippled(cloth, dimension); }
bool is_bent(const ClothCase& cloth, int dimension) {
  return is_sheet(cloth, dimension) || cloth.arrangement == Arrangement::random ||
         cloth.arrangement == Arrangement::dropped;
}

void add_book(Table<ClothCase>& table) {
  table
      .key("inner_radius", &ClothCase::inner_radius, quantity(measure::length, at_least(0)),
           "book: from the axis to the inner edge")
      .fallback("0.477 of the tub radius")
      .only("for \"book\"", is_book)
      .key("bottom", &ClothCase::bottom, quantity(measure::length, at_least(0)),
           "book: height of the lower edge")
      .fallback("0.328 of the water depth")
      .only("for \"book\"", is_book)
      .key("shift", &ClothCase::shift, quantity(measure::length, at_least(0)),
           "book: standard deviation of the random shift")
      .fallback("0.0129 of the tub radius")
      .only("for \"book\"", is_book)
      .key("tilt", &ClothCase::tilt, quantity(measure::angle, at_least(0)),
           "book: standard deviation of the random tilt")
      .fallback("4 deg")
      .only("for \"book\"", is_book)
      .key("clearance", &ClothCase::clearance, quantity(measure::length, at_least(0)),
           "smallest distance to solids, surface and other pieces")
      .fallback("0.0129 of the tub radius")
      .only("for \"book\", \"random\", \"dropped\" and \"layers\"", is_placed);
}

void add_packet(Table<ClothCase>& table) {
  table
      .key("folded", &ClothCase::folded, sheet_counts(between(1, 8)),
           "into so many layers along its edges: 2 in halves, 3 in thirds")
      .only("for \"book\", \"random\", \"dropped\" and \"layers\"", is_placed)
      .key("crumpled", &ClothCase::crumpled, number(between(0, 0.6)),
           "part of its extent that a piece loses in random creases")
      .only("for \"book\", \"random\", \"dropped\" and \"layers\"", is_placed);
}

/// Pointer to a direction of a sheet.
template <size_t i>
Vec<3>& along(ClothCase& cloth) {
  return cloth.along[i];
}

Format<std::vector<Edge>> edges() {
  return choices<Edge>({{"r_lower", Edge::r_lower},
                        {"r_upper", Edge::r_upper},
                        {"s_lower", Edge::s_lower},
                        {"s_upper", Edge::s_upper}});
}

void add_sheet(Table<ClothCase>& table) {
  table.key("origin", &ClothCase::origin, vector(measure::length), "sheet: its first corner")
      .only("for \"sheet\"", is_sheet)
      .key("along_r", along<0>, direction(), "sheet: direction of its first edge")
      .only("for \"sheet\"", is_sheet)
      .key("along_s", along<1>, direction(), "sheet: direction of its second edge")
      .only("for \"sheet\" in 3-D",
            [](const ClothCase& cloth, int dimension) {
              return dimension == 3 && is_sheet(cloth, dimension);
            })
      .key("closed", &ClothCase::closed, sheet_flags(),
           "sheet: goes on beyond a periodic side of the box, which it spans; `size` is its rest "
           "length there")
      .only("for \"sheet\"", is_sheet)
      .key("pinned", &ClothCase::pinned, edges(),
           "sheet: edges whose nodes do not move; they may stand in a solid at rest")
      .only("for \"sheet\"", is_sheet)
      .key("clamped", &ClothCase::clamped, edges(),
           "sheet: edges whose two rows of nodes do not move; the clamp acts midway between the "
           "rows, from where `origin` and `size` count")
      .only("for \"sheet\"", is_sheet);
}

void add_ring(Table<ClothCase>& table) {
  table.key("centre", &ClothCase::centre, vector(measure::length), "ring: its centre")
      .only("for \"ring\"", is_ring)
      .key("radius", &ClothCase::radius, quantity(measure::length, above(0)),
           "ring: at the start; `size` is its rest length")
      .only("for \"ring\"", is_ring)
      .required();
}

void add_bend(Table<ClothCase>& table) {
  table
      .key("curvature", &ClothCase::curvature, quantity(measure::curvature),
           "at the start, along the first edge; towards the left of it, or to where the sheet's "
           "normal points. At rest cloth is flat")
      .only("for \"random\", \"dropped\" and \"sheet\"", is_bent)
      .key("ripple", &ClothCase::ripple, quantity(measure::length),
           "amplitude of waves at the start, normal to the cloth: sin(2 pi ripples r / length), in "
           "a ring cos, outwards")
      .only("for \"sheet\" and \"ring\"", is_rippled)
      .key("ripples", &ClothCase::ripples, number(above(0)),
           "number of such waves along the first edge")
      .only("for \"sheet\" and \"ring\"", is_rippled);
}

/// Makes unit vectors of the directions of a sheet, and refuses those that span none.
void normalise(ClothCase& cloth, const Node& node, int dimension) {
  if (!is_sheet(cloth, dimension)) return;
  for (Vec<3>& direction : cloth.along) {
    if (direction.norm() == 0) throw error_at(node, "along_r and along_s must not be zero");
    if (std::abs(direction.norm() - 1) > 1e-12) direction.normalize();
  }
  if (dimension == 3 && std::abs(cloth.along[0].dot(cloth.along[1])) > 1e-9)
    throw error_at(node, "along_r and along_s must be at right angles");
}

}  // namespace

void add_start(Table<ClothCase>& table) {
  add_book(table);
  add_packet(table);
  add_sheet(table);
  add_ring(table);
  add_bend(table);
  table.then(normalise);
}

}  // namespace washtub
