#include <cmath>

#include "case/parts.hpp"

namespace washtub {
namespace {

using Spec = ShapeSpec;

bool in_space(const Spec&, int dimension) { return dimension == 3; }

/// Every kind of shape can be turned about the vertical.
Table<Spec> shape_table(const std::string& meaning) {
  Table<Spec> table(meaning);
  table.key("angle", &Spec::angle, quantity(measure::angle), "turned about z by this")
      .omitted([](const Spec& spec, int) { return spec.angle == 0; })
      .fallback("`\"0 rad\"`");
  return table;
}

Table<Spec> sphere_table() {
  return shape_table("A ball; a disc in 2-D.")
      .key("radius", &Spec::radius, quantity(measure::length, above(0)), "radius")
      .required()
      .key("centre", &Spec::centre, vector(measure::length), "centre");
}

Table<Spec> cylinder_table() {
  return shape_table("An upright cylinder about z; a disc in 2-D.")
      .key("radius", &Spec::radius, quantity(measure::length, above(0)), "radius")
      .required()
      .key("z_lower", &Spec::z_lower, quantity(measure::length), "height of the lower end")
      .omitted([](const Spec& s, int) { return std::isinf(s.z_lower); })
      .only("in 3-D", in_space)
      .key("z_upper", &Spec::z_upper, quantity(measure::length), "height of the upper end")
      .omitted([](const Spec& s, int) { return std::isinf(s.z_upper); })
      .only("in 3-D", in_space);
}

Table<Spec> box_table() {
  auto ordered = [](Spec& spec, const Node& node, int dimension) {
    for (int axis = 0; axis < dimension; ++axis)
      if (spec.upper[axis] <= spec.lower[axis])
        throw error_at(*node.find("upper"), "expected a corner above `lower` along every axis");
  };
  return shape_table("A box along the axes; a rectangle in 2-D.")
      .key("lower", &Spec::lower, vector(measure::length), "lower corner")
      .required()
      .key("upper", &Spec::upper, vector(measure::length), "upper corner")
      .required()
      .then(ordered);
}

Table<Spec> capsule_table() {
  return shape_table("All points near a segment.")
      .key("a", &Spec::a, vector(measure::length), "one end of the segment")
      .required()
      .key("b", &Spec::b, vector(measure::length), "the other end")
      .required()
      .key("radius", &Spec::radius, quantity(measure::length, above(0)), "distance to the segment")
      .required();
}

Table<Spec> half_space_table() {
  auto pointing = [](Spec& spec, const Node& node, int) {
    if (spec.normal.norm() == 0) throw error_at(*node.find("normal"), "expected a direction");
  };
  return shape_table("Everything behind a plane.")
      .key("point", &Spec::point, vector(measure::length), "a point of the plane")
      .required()
      .key("normal", &Spec::normal, direction(), "direction out of the solid")
      .required()
      .then(pointing);
}

void check_outline(Spec& spec, const Node& node, int dimension) {
  if (dimension != 3) throw error_at(node, "only in 3-D");
  if (spec.outline.size() < 3)
    throw error_at(*node.find("outline"), "expected a polygon of three points or more");
}

Table<Spec> revolution_table() {
  auto outside_axis = [](Spec& spec, const Node& node, int) {
    for (const auto& vertex : spec.outline)
      if (vertex.x() < 0) throw error_at(*node.find("outline"), "expected radii of 0 or more");
  };
  return shape_table("A closed outline turned about z; 3-D only.")
      .key("outline", &Spec::outline, points(measure::length), "(r, z) of its vertices")
      .required()
      .then(check_outline)
      .then(outside_axis);
}

Table<Spec> plate_table() {
  return shape_table("A closed outline in the plane y = 0, thickened; 3-D only.")
      .key("outline", &Spec::outline, points(measure::length), "(x, z) of its vertices")
      .required()
      .key("half_thickness", &Spec::half_thickness, quantity(measure::length, above(0)),
           "extent to either side")
      .required()
      .then(check_outline);
}

/// The shapes that another one is made of.
Format<std::vector<Spec>> parts_format() {
  auto read = [](const Node& node, int dimension) {
    std::vector<Spec> parts;
    if (!node.is_list() || node.list().empty()) throw error_at(node, "expected a list of shapes");
    for (const Node& entry : node.list()) parts.push_back(shape_kinds().read(entry, dimension));
    return parts;
  };
  auto write = [](const std::vector<Spec>& parts, int dimension) {
    std::string text;
    for (const Spec& part : parts)
      text += (text.empty() ? "" : ", ") + shape_kinds().format().write(part, dimension);
    return "[" + text + "]";
  };
  return {read, write, "list of shapes", "", json_schema::list(json_schema::reference("shape"), 1)};
}

Table<Spec> combination_table(const std::string& meaning) {
  return shape_table(meaning).key("parts", &Spec::parts, parts_format(), "the shapes").required();
}

Table<Spec> complement_table() {
  auto single = [](Spec& spec, const Node& node, int) {
    if (spec.parts.size() != 1) throw error_at(*node.find("parts"), "expected a single shape");
  };
  return combination_table("Everything outside of a shape.").then(single);
}

Table<Spec> difference_table() {
  auto several = [](Spec& spec, const Node& node, int) {
    if (spec.parts.size() < 2) throw error_at(*node.find("parts"), "expected two shapes or more");
  };
  return combination_table("The first part without the others.").then(several);
}

Shape box_shape(const Spec& spec, int dimension) {
  Vec<3> lower = spec.lower, upper = spec.upper;
  if (dimension == 2) {
    const double far = (upper - lower).norm();
    lower.z() = -far;
    upper.z() = far;
  }
  return box(lower, upper);
}

std::vector<Shape> make_parts(const Spec& spec, int dimension) {
  std::vector<Shape> shapes;
  for (const Spec& part : spec.parts) shapes.push_back(shape_kinds().make(part, dimension));
  return shapes;
}

Shape difference_shape(const Spec& spec, int dimension) {
  const std::vector<Shape> parts = make_parts(spec, dimension);
  return subtract(parts.front(), unite({parts.begin() + 1, parts.end()}));
}

/// What makes a shape, turned about z after everything else.
template <class Make>
auto turned(Make make) {
  return [=](const Spec& spec, int dimension) {
    const Shape shape = make(spec, dimension);
    return spec.angle == 0 ? shape : rotate_z(shape, spec.angle);
  };
}

/// Shapes that do not depend on the dimension.
template <class Make>
auto simple(Make make) {
  return turned([=](const Spec& spec, int) { return make(spec); });
}

/// Shapes made of parts.
template <class Make>
auto combined(Make make) {
  return turned([=](const Spec& spec, int dimension) { return make(make_parts(spec, dimension)); });
}

}  // namespace

const Kinds<ShapeSpec, Shape>& shape_kinds() {
  using Parts = const std::vector<Shape>&;
  static const auto kinds =
      Kinds<Spec, Shape>("shape")
          .kind("sphere", sphere_table(),
                simple([](const Spec& s) { return sphere(s.centre, s.radius); }))
          .kind("cylinder", cylinder_table(),
                simple([](const Spec& s) { return cylinder(s.radius, s.z_lower, s.z_upper); }))
          .kind("box", box_table(), turned(box_shape))
          .kind("capsule", capsule_table(),
                simple([](const Spec& s) { return capsule(s.a, s.b, s.radius); }))
          .kind("half-space", half_space_table(),
                simple([](const Spec& s) { return half_space(s.point, s.normal.normalized()); }))
          .kind("revolution", revolution_table(),
                simple([](const Spec& s) { return revolution(s.outline); }))
          .kind("plate", plate_table(),
                simple([](const Spec& s) { return plate(s.outline, s.half_thickness); }))
          .kind("union", combination_table("All of its parts together."),
                combined([](Parts parts) { return unite(parts); }))
          .kind("intersection", combination_table("What its parts have in common."),
                combined([](Parts parts) { return intersect(parts); }))
          .kind("difference", difference_table(), turned(difference_shape))
          .kind("complement", complement_table(),
                combined([](Parts parts) { return complement(parts.front()); }));
  return kinds;
}

Table<SolidSpec> solid_table() {
  Table<SolidSpec> table(
      "A rigid solid: a shape in its own frame, whose origin is at `centre` and about whose "
      "vertical it turns. Repeat `[[solid]]` for several. One named \"tub\" or \"agitator\" takes "
      "the place of the one that `[washer]` makes.");
  table.key("name", &SolidSpec::name, label(), "name in messages and results")
      .required()
      .key("shape", &SolidSpec::shape, shape_kinds().format(), "see the kinds of shape below")
      .required()
      .key("centre", &SolidSpec::centre, vector(measure::length), "where its axis is")
      .key("angle", &SolidSpec::angle, quantity(measure::angle), "turned about its axis at t = 0")
      .key("drive", &SolidSpec::drive, drive_kinds().format(), "see the kinds of drive below");
  return table;
}

}  // namespace washtub
