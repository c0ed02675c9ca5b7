#include <algorithm>
#include <numeric>
#include <set>

#include "case/tables.hpp"

namespace washtub {

Table<ProbeCase> probe_table() {
  Table<ProbeCase> table(
      "A node of cloth whose place goes into history.csv, as the columns \"name x\" and so on. "
      "Repeat `[[probe]]` for several.");
  table.key("name", &ProbeCase::name, label(), "of its columns")
      .required()
      .key("piece", &ProbeCase::piece, integer(between(1, 1000000)),
           "number of the piece among all, from 1")
      .key("node", &ProbeCase::node, sheet_counts(between(-4096, 4095)),
           "number of the node along the edges, from 0; -1 is the last one")
      .required();
  return table;
}

Table<ExactCase> exact_table() {
  Table<ExactCase> table(
      "A known velocity. With it, history.csv has the largest and the rms error of the velocity "
      "components over the open faces inside the water.");
  table
      .key("velocity", &ExactCase::velocity, formulas(measure::speed, true),
           "of the exact solution")
      .required()
      .key("relative", &ExactCase::relative, boolean(),
           "errors over the exact speed at each face, as in Eq. (A.13); where that is zero the "
           "face is left out");
  return table;
}

namespace {

/// The group that piece `piece`, from 1, belongs to; null beyond the last piece.
const ClothCase* group_of(const Case& whole, int piece) {
  for (const ClothCase& group : whole.cloth) {
    if (piece <= group.count) return &group;
    piece -= group.count;
  }
  return nullptr;
}

void check_probe(const Case& whole, const Node& root, size_t i) {
  const ProbeCase& probe = whole.probes[i];
  const std::string key =
      whole.probes.size() > 1 ? fmt::format("probe[{}].", i + 1) : std::string("probe.");
  const ClothCase* group = group_of(whole, probe.piece);
  if (!group) {
    const int pieces =
        std::accumulate(whole.cloth.begin(), whole.cloth.end(), 0,
                        [](int sum, const ClothCase& cloth) { return sum + cloth.count; });
    throw error_at_key(root, key + "piece", std::to_string(probe.piece),
                       fmt::format("there are {} pieces of cloth", pieces));
  }
  const auto nodes = cloth_nodes(*group, whole);
  for (size_t d = 0; d + 1 < static_cast<size_t>(whole.dimension); ++d)
    if (probe.node[d] < -nodes[d] || probe.node[d] >= nodes[d])
      throw error_at_key(root, key + "node", "",
                         fmt::format("the piece has {} nodes along {}, allowed: {} to {}", nodes[d],
                                     d == 0 ? "r" : "s", -nodes[d], nodes[d] - 1));
}

}  // namespace

void check_probes(const Case& whole, const Node& root) {
  std::set<std::string> seen;
  for (size_t i = 0; i < whole.probes.size(); ++i) {
    check_probe(whole, root, i);
    if (!seen.insert(whole.probes[i].name).second)
      throw InputError(fmt::format("{}: probe.name = \"{}\": two probes have this name", root.where,
                                   whole.probes[i].name));
  }
}

}  // namespace washtub
