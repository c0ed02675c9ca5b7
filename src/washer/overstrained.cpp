#include "washer/overstrained.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <span>

namespace washtub {
namespace {

std::string node_text(const WorstEdge& edge, int dimension) {
  return dimension == 2 ? fmt::format("node {}", edge.node[1])
                        : fmt::format("node ({}, {})", edge.node[0], edge.node[1]);
}

/// The implicit scheme's tension is what the water asks for, whatever the step: the finer the grid,
/// the less water it ties to the cloth. The others may be unstable.
std::string remedy(const Case& whole) {
  const std::span cells(whole.domain.cells.data(), static_cast<std::size_t>(whole.dimension));
  const std::string grid = fmt::format(
      "more domain.cells than {} or a larger cloth.stretch_stiffness", fmt::join(cells, " x "));
  return whole.coupling.scheme == Scheme::implicit
             ? grid + "; a smaller time.step seldom helps"
             : "a smaller time.step, coupling.scheme = \"implicit\", " + grid;
}

}  // namespace

std::string overstrained(const WorstEdge& edge, const Case& whole) {
  const double limit = whole.coupling.strain_limit;
  const bool longer = edge.strain > 0;
  return fmt::format(
      "piece {} of the cloth is {} by {:.3g} % at {}, limit {:.3g} % "
      "(coupling.strain_limit = {}); try {}",
      edge.piece + 1, longer ? "stretched" : "shortened", 100 * std::abs(edge.elongation()),
      node_text(edge, whole.dimension), 100 * std::abs(elongation(longer ? limit : -limit)), limit,
      (limit < CouplingCase().strain_limit ? "a larger coupling.strain_limit, or " : "") +
          remedy(whole));
}

}  // namespace washtub
