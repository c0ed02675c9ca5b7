#include <cmath>
#include <numbers>

#include "case/tables.hpp"

namespace washtub {
namespace {

std::string seconds(double time) { return fmt::format("\"{:.6g} s\"", time); }

/// The key's node where the file gives it and --set does not; else null.
const Node* of_file(const Node& root, const std::string& key) {
  const Node* node = find_key(root, key);
  return node && node->where != "--set" ? node : nullptr;
}

void fit_window(Case& whole, const Node& node) {
  OutputCase& output = whole.output;
  const double end = whole.time.end;
  if (output.window_end <= end * (1 + 1e-9)) return;
  const std::string place = fmt::format("{}: output.window = {}", node.where, value_text(node));
  output.window_end = end;
  if (output.window_begin < end) {
    whole.notes.push_back(
        fmt::format("{}: cut off at {}, where --set time.end ends the run", place, seconds(end)));
    return;
  }
  output.window_begin = 0;
  whole.notes.push_back(
      fmt::format("{}: begins after {}, where --set time.end ends the run; statistics are taken of "
                  "the whole run, its start included",
                  place, seconds(end)));
}

}  // namespace

void fit_output(CaseFile& file, const Node& root, int) {
  Case& whole = file.result;
  const Node* end = find_key(root, "time.end");
  if (!end || end->where != "--set") return;
  if (const Node* window = of_file(root, "output.window")) fit_window(whole, *window);
  const Node* every = of_file(root, "output.every");
  if (!every || whole.output.every <= whole.time.end) return;
  whole.output.every = whole.time.end;
  whole.notes.push_back(fmt::format("{}: output.every = {}: longer than the run, taken as {}",
                                    every->where, value_text(*every), seconds(whole.time.end)));
}

/// A drive that starts again at another speed than it ended with.
void note_jumps(CaseFile& file, const Node&, int) {
  constexpr double rpm = std::numbers::pi / 30;
  for (const SolidCase& solid : file.result.solids) {
    const Drive& drive = solid.drive;
    if (drive.period() <= 0) continue;
    const double last = drive.speed(drive.period() * (1 - 1e-12)), first = drive.speed(0);
    if (std::abs(last - first) <= 1e-6 * drive.peak()) continue;
    file.result.notes.push_back(fmt::format(
        "solid \"{}\": its speed jumps from {:.4g} to {:.4g} rpm every {:.6g} s, where its table "
        "starts again; the blow of the water stands in one row of the results. Let the last of "
        "`speeds` equal the first, or set `repeat = false`",
        solid.name, last / rpm, first / rpm, drive.period()));
  }
}

}  // namespace washtub
