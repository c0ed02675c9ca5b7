#include "io/xdmf.hpp"

#include <fmt/format.h>

#include <cstdlib>

namespace washtub {
namespace {

constexpr std::string_view head = R"(<?xml version="1.0" encoding="utf-8"?>
<Xdmf Version="3.0">
  <Domain>
    <Grid Name="washtub" GridType="Collection" CollectionType="Temporal">
)";
constexpr std::string_view tail = R"(    </Grid>
  </Domain>
</Xdmf>
)";
constexpr std::string_view frame_begin = "      <Grid Name=\"frame\"";
constexpr std::string_view frame_end = "      </Grid>\n";

std::string escaped(const std::string& text) {
  std::string out;
  for (const char c : text) {
    if (c == '&')
      out += "&amp;";
    else if (c == '<')
      out += "&lt;";
    else if (c == '"')
      out += "&quot;";
    else
      out += c;
  }
  return out;
}

/// Values kept in the HDF5 file; `path` is "file:/dataset".
std::string stored(const std::string& path, const std::string& dimensions, const char* type,
                   int precision) {
  return fmt::format(
      "<DataItem Format=\"HDF\" Dimensions=\"{}\" NumberType=\"{}\" Precision=\"{}\">{}</DataItem>",
      dimensions, type, precision, escaped(path));
}

std::string attribute(const std::string& name, const char* type, const char* center,
                      const std::string& item) {
  return fmt::format(
      "          <Attribute Name=\"{}\" AttributeType=\"{}\" Center=\"{}\">{}</Attribute>\n",
      escaped(name), type, center, item);
}

/// Three numbers slowest axis first, as XDMF wants them.
std::string reversed(const Vec<3>& v) {
  return fmt::format(
      "<DataItem Format=\"XML\" Dimensions=\"3\" NumberType=\"Float\" Precision=\"8\">{:.17g} "
      "{:.17g} {:.17g}</DataItem>",
      v[2], v[1], v[0]);
}

std::string fluid_element(const std::string& file, const FluidGrid& grid,
                          const std::vector<FrameNumber>& numbers) {
  const auto& n = grid.cells;
  const std::string cells = fmt::format("{} {} {}", n[2], n[1], n[0]);
  std::string text = fmt::format(
      "        <Grid Name=\"fluid\" GridType=\"Uniform\">\n"
      "          <Topology TopologyType=\"3DCoRectMesh\" Dimensions=\"{} {} {}\"/>\n"
      "          <Geometry GeometryType=\"ORIGIN_DXDYDZ\">{}{}</Geometry>\n",
      n[2] + 1, n[1] + 1, n[0] + 1, reversed(grid.lower), reversed(grid.spacing));
  text += attribute("velocity [m/s]", "Vector", "Cell",
                    stored(file + ":/fluid/velocity", cells + " 3", "Float", 4));
  text += attribute("pressure [Pa]", "Scalar", "Cell",
                    stored(file + ":/fluid/pressure", cells, "Float", 4));
  text += attribute("solid fraction", "Scalar", "Cell",
                    stored(file + ":/fluid/solid", cells, "Float", 4));
  for (const FrameNumber& number : numbers)
    text += attribute(number.name, "Scalar", "Grid",
                      fmt::format("<DataItem Format=\"XML\" Dimensions=\"1\" NumberType=\"Float\" "
                                  "Precision=\"8\">{:.17g}</DataItem>",
                                  number.value));
  return text + "        </Grid>\n";
}

std::string cloth_element(const std::string& file, const ClothTopology& cloth) {
  const std::string nodes = fmt::format("{}", cloth.nodes);
  const std::string shape =
      cloth.corners == 4
          ? "TopologyType=\"Quadrilateral\""
          : fmt::format("TopologyType=\"Polyline\" NodesPerElement=\"{}\"", cloth.corners);
  std::string text = fmt::format(
      "        <Grid Name=\"cloth\" GridType=\"Uniform\">\n"
      "          <Topology {} NumberOfElements=\"{}\">{}</Topology>\n"
      "          <Geometry GeometryType=\"XYZ\">{}</Geometry>\n",
      shape, cloth.cells,
      stored(file + ":/cloth/cells", fmt::format("{} {}", cloth.cells, cloth.corners), "Int", 4),
      stored(file + ":/cloth/positions", nodes + " 3", "Float", 8));
  for (const char* part : {"membrane", "bending", "total"})
    text += attribute(fmt::format("{} stress [Pa]", part), "Scalar", "Node",
                      stored(fmt::format("{}:/cloth/{}", file, part), nodes, "Float", 8));
  text += attribute("piece", "Scalar", "Cell",
                    stored(file + ":/cloth/piece", fmt::format("{}", cloth.cells), "Int", 4));
  return text + "        </Grid>\n";
}

}  // namespace

FluidGrid fluid_grid(const Mesh<3>& mesh) { return {mesh.cells, mesh.lower, mesh.h}; }

FluidGrid fluid_grid(const Mesh<2>& mesh) {
  const double thickness = mesh.h.minCoeff();
  return {{mesh.cells[0], mesh.cells[1], 1},
          {mesh.lower[0], mesh.lower[1], -thickness},
          {mesh.h[0], mesh.h[1], thickness}};
}

void FrameIndex::add(double time, const std::string& file, const FluidGrid& fluid,
                     const ClothTopology& cloth, const std::vector<FrameNumber>& numbers) {
  std::string frame = fmt::format(
      "{} GridType=\"Collection\" CollectionType=\"Spatial\">\n"
      "        <Time Value=\"{:.17g}\"/>\n",
      frame_begin, time);
  frame += fluid_element(file, fluid, numbers);
  if (cloth.cells > 0) frame += cloth_element(file, cloth);
  entries_.push_back({time, frame.append(frame_end)});
}

void FrameIndex::restore(const std::string& text, double until) {
  entries_.clear();
  constexpr std::string_view key = "<Time Value=\"";
  const std::string last_line = fmt::format("\n{}", frame_end);
  for (std::size_t begin = text.find(frame_begin); begin != std::string::npos;) {
    const std::size_t time = text.find(key, begin), end = text.find(last_line, begin);
    if (time == std::string::npos || end == std::string::npos) return;
    const double value = std::strtod(text.c_str() + time + key.size(), nullptr);
    const std::size_t next = end + last_line.size();
    if (value <= until) entries_.push_back({value, text.substr(begin, next - begin)});
    begin = text.find(frame_begin, next);
  }
}

std::string FrameIndex::text() const {
  std::string all(head);
  for (const Entry& e : entries_) all += e.frame;
  return all.append(tail);
}

}  // namespace washtub
