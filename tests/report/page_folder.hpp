#pragma once
#include <cmath>
#include <nlohmann/json.hpp>

#include "inflate.hpp"
#include "io/frame.hpp"
#include "report/page.hpp"
#include "support/run_folder.hpp"

namespace washtub::testing {

/// Frames that FrameWriter writes: water that differs from cell to cell, and two pieces of cloth.
struct MadeFrames {
  int dimension = 3;
  std::array<int, 3> cells = {16, 16, 16};
  int count = 5;
  bool cloth = true;
  std::array<int, 2> nodes = {3, 4};  ///< of each piece

  std::size_t size() const {
    return static_cast<std::size_t>(cells[0]) * static_cast<std::size_t>(cells[1]) *
           static_cast<std::size_t>(cells[2]);
  }
  static double time(int frame) { return 0.5 * frame; }
  float velocity(int frame, std::size_t cell, std::size_t axis) const {
    const double phase = static_cast<double>(cell * cell % 100003 + axis);
    return static_cast<float>(std::sin(phase + 1.3 * frame) + 0.1 * static_cast<double>(axis));
  }
  static double position(int frame, std::size_t node, int axis) {
    return 0.01 * static_cast<double>(node) + 0.1 * axis + 0.02 * frame;
  }
  static double stress(int frame, std::size_t node) {
    return 100.0 * static_cast<double>(node) + frame;
  }

  void write(const std::string& directory) const {
    FrameWriter writer(directory, Parallel(), dimension,
                       {cells, Vec<3>::Zero(), Vec<3>::Constant(1)});
    for (int f = 0; f < count; ++f) write(writer, f);
  }

 private:
  void write(FrameWriter& writer, int f) const {
    std::vector<float> u, pressure(size(), 0.F), solid(size(), 0.F);
    for (std::size_t c = 0; c < size(); ++c)
      for (std::size_t d = 0; d < 3; ++d) u.push_back(velocity(f, c, d));
    solid[0] = 1;
    const auto each = static_cast<std::size_t>(nodes[0] * nodes[1]);
    std::vector<double> x, s;
    for (std::size_t n = 0; n < 2 * each; ++n) {
      for (int d = 0; d < dimension; ++d) x.push_back(position(f, n, d));
      s.push_back(stress(f, n));
    }
    const std::span<const double> places(x), stresses(s);
    const std::size_t width = each * static_cast<std::size_t>(dimension);
    const auto stress_field = [](const std::string& name) {
      return FieldDescription{name, name + " stress", "Pa", 1, ""};
    };
    Frame frame{time(f),
                {{0, 0, 0},
                 cells,
                 {{{"velocity", "velocity", "m/s", 3, ""}, u},
                  {{"pressure", "pressure", "Pa", 1, ""}, pressure},
                  {{"solid", "solid fraction", "", 1, ""}, solid}}},
                {stress_field("membrane"), stress_field("bending"), stress_field("total")},
                {},
                {{"agitator", 0.1 * f}}};
    for (std::size_t p = 0; cloth && p < 2; ++p) {
      const auto part = stresses.subspan(p * each, each);
      frame.cloth.push_back({nodes, places.subspan(p * width, width), {part, part, part}, {}});
    }
    writer.write(frame);
  }
};

/// What a browser finds in a page.
struct ReadPage {
  nlohmann::ordered_json index;
  std::string text;

  explicit ReadPage(const std::string& path) : text(contents(path)) {
    index = nlohmann::ordered_json::parse(element("washtub-data"));
  }
  std::string element(const std::string& id) const {
    const auto start = text.find('>', text.find("id=\"" + id + '"')) + 1;
    return text.substr(start, text.find('<', start) - start);
  }
  template <class T>
  std::vector<T> chunk(const nlohmann::ordered_json& number) const {
    return inflate_as<T>(element("washtub-chunk-" + std::to_string(number.get<int>())));
  }
  const nlohmann::ordered_json& run() const { return index["runs"][0]; }
  const nlohmann::ordered_json& frames() const { return run()["frames"]; }
};

}  // namespace washtub::testing
