#include "io/xdmf.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cstdlib>

namespace washtub {
namespace {

constexpr std::string_view head = R"(<?xml version="1.0" encoding="utf-8"?>
<Xdmf Version="3.0">
  <Domain>
)";
constexpr std::string_view tail = R"(  </Domain>
</Xdmf>
)";
constexpr std::string_view mesh_end = "      </Grid>\n";
constexpr std::string_view time_key = "<Time Value=\"";

/// First lines of one mesh at one time.
std::string mesh_begin(const char* name, double time) {
  return fmt::format(
      "      <Grid Name=\"{}\" GridType=\"Uniform\">\n"
      "        {}{:.17g}\"/>\n",
      name, time_key, time);
}

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
      "        <Attribute Name=\"{}\" AttributeType=\"{}\" Center=\"{}\">{}</Attribute>\n",
      escaped(name), type, center, item);
}

/// Three numbers slowest axis first, as XDMF wants them.
std::string reversed(const Vec<3>& v) {
  return fmt::format(
      "<DataItem Format=\"XML\" Dimensions=\"3\" NumberType=\"Float\" Precision=\"8\">{:.17g} "
      "{:.17g} {:.17g}</DataItem>",
      v[2], v[1], v[0]);
}

std::string fluid_element(double time, const std::string& file, const FluidGrid& grid,
                          const std::vector<FieldDescription>& fields,
                          const std::vector<FrameNumber>& numbers) {
  const auto& n = grid.cells;
  const std::string cells = fmt::format("{} {} {}", n[2], n[1], n[0]);
  std::string text = mesh_begin("fluid", time);
  text += fmt::format(
      "        <Topology TopologyType=\"3DCoRectMesh\" Dimensions=\"{} {} {}\"/>\n"
      "        <Geometry GeometryType=\"ORIGIN_DXDYDZ\">{}{}</Geometry>\n",
      n[2] + 1, n[1] + 1, n[0] + 1, reversed(grid.lower), reversed(grid.spacing));
  for (const FieldDescription& field : fields) {
    const bool vector = field.components > 1;
    const std::string size = vector ? fmt::format("{} {}", cells, field.components) : cells;
    text += attribute(heading(field), vector ? "Vector" : "Scalar", "Cell",
                      stored(file + ":/fluid/" + field.name, size, "Float", 4));
  }
  for (const FrameNumber& number : numbers)
    text += attribute(number.name, "Scalar", "Grid",
                      fmt::format("<DataItem Format=\"XML\" Dimensions=\"1\" NumberType=\"Float\" "
                                  "Precision=\"8\">{:.17g}</DataItem>",
                                  number.value));
  return text.append(mesh_end);
}

std::string cloth_element(double time, const std::string& file, const ClothTopology& cloth,
                          const std::vector<FieldDescription>& fields) {
  const std::string nodes = fmt::format("{}", cloth.nodes);
  const std::string shape =
      cloth.corners == 4
          ? "TopologyType=\"Quadrilateral\""
          : fmt::format("TopologyType=\"Polyline\" NodesPerElement=\"{}\"", cloth.corners);
  std::string text = mesh_begin("cloth", time);
  text += fmt::format(
      "        <Topology {} NumberOfElements=\"{}\">{}</Topology>\n"
      "        <Geometry GeometryType=\"XYZ\">{}</Geometry>\n",
      shape, cloth.cells,
      stored(file + ":/cloth/cells", fmt::format("{} {}", cloth.cells, cloth.corners), "Int", 4),
      stored(file + ":/cloth/positions", nodes + " 3", "Float", 8));
  for (const FieldDescription& field : fields)
    text += attribute(heading(field), "Scalar", "Node",
                      stored(file + ":/cloth/" + field.name, nodes, "Float", 8));
  text += attribute("piece", "Scalar", "Cell",
                    stored(file + ":/cloth/piece", fmt::format("{}", cloth.cells), "Int", 4));
  return text.append(mesh_end);
}

/// The elements of one mesh that an earlier frames.xdmf lists, in its order.
std::vector<std::string> elements(const std::string& text, const char* name) {
  const std::string first_line = fmt::format("      <Grid Name=\"{}\" GridType=\"Uniform\">", name);
  const std::string last_line = fmt::format("\n{}", mesh_end);
  std::vector<std::string> found;
  for (std::size_t begin = text.find(first_line); begin != std::string::npos;) {
    const std::size_t end = text.find(last_line, begin);
    if (end == std::string::npos) break;
    found.push_back(text.substr(begin, end + last_line.size() - begin));
    begin = text.find(first_line, end);
  }
  return found;
}

double time_of(const std::string& element) {
  return std::strtod(element.c_str() + element.find(time_key) + time_key.size(), nullptr);
}

/// One mesh through all times; nothing where it is in no frame.
std::string collection(const char* name, const std::string& meshes) {
  if (meshes.empty()) return {};
  return fmt::format(
      "    <Grid Name=\"{}\" GridType=\"Collection\" CollectionType=\"Temporal\">\n"
      "{}    </Grid>\n",
      name, meshes);
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
                     const ClothTopology& cloth, const FrameFields& fields,
                     const std::vector<FrameNumber>& numbers) {
  entries_.push_back({time, fluid_element(time, file, fluid, fields.fluid, numbers),
                      cloth.cells > 0 ? cloth_element(time, file, cloth, fields.cloth) : ""});
}

void FrameIndex::restore(const std::string& text, std::size_t frames) {
  entries_.clear();
  const std::vector<std::string> fluid = elements(text, "fluid"), cloth = elements(text, "cloth");
  for (std::size_t i = 0; i < std::min(frames, fluid.size()); ++i)
    entries_.push_back({time_of(fluid[i]), fluid[i], i < cloth.size() ? cloth[i] : ""});
}

std::string FrameIndex::text() const {
  std::string fluid, cloth;
  for (const Entry& e : entries_) {
    fluid += e.fluid;
    cloth += e.cloth;
  }
  return fmt::format("{}{}{}{}", head, collection("fluid", fluid), collection("cloth", cloth),
                     tail);
}

std::string paraview_index() {
  return R"xml(<?xml version="1.0" encoding="utf-8"?>
<Xdmf Version="3.0" xmlns:xi="http://www.w3.org/2001/XInclude">
  <xi:include href="frames.xdmf" xpointer="xpointer(//Xdmf/Domain)"/>
</Xdmf>
)xml";
}

}  // namespace washtub
