#include "verify/report.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <cmath>

namespace washtub {
namespace {

using Json = nlohmann::ordered_json;

std::string with_unit(double value, const std::string& unit) {
  if (std::isnan(value)) return "-";
  return fmt::format("{:.4g}{}{}", value, unit.empty() ? "" : " ", unit);
}

/// "0.0365 ± 4 %", ">= 1.8".
std::string reference_text(const Quantity& q) {
  if (!std::isnan(q.at_least)) return ">= " + with_unit(q.at_least, q.unit);
  if (!std::isnan(q.at_most)) return "<= " + with_unit(q.at_most, q.unit);
  if (!std::isnan(q.tolerance_percent))
    return fmt::format("{} ± {:g} %", with_unit(q.value, q.unit), q.tolerance_percent);
  if (std::isnan(q.tolerance)) return with_unit(q.value, q.unit);
  return fmt::format("{:.4g} ± {}", q.value, with_unit(q.tolerance, q.unit));
}

/// In percent of a value, unless its tolerance is a number.
std::string deviation_text(const Quantity& q, const Judgement& j) {
  if (std::isnan(j.deviation)) return "-";
  const double scale = std::abs(reference(q));
  const bool percent = !std::isnan(q.value) && scale > 0 && std::isnan(q.tolerance);
  return percent ? fmt::format("{:+.3g} %", 100 * j.deviation / scale)
                 : fmt::format("{:+.2g}", j.deviation);
}

/// Width on a terminal: UTF-8 bytes that start a character.
std::size_t width(const std::string& text) {
  return static_cast<std::size_t>(
      std::count_if(text.begin(), text.end(), [](char c) { return (c & 0xC0) != 0x80; }));
}

using Cells = std::array<std::string, 6>;

Cells cells(const Row& r) {
  return {r.name, r.quantity, r.measured, r.reference, r.deviation, r.verdict};
}

/// Columns as wide as their widest entry.
std::string aligned(const std::vector<Cells>& rows) {
  std::array<std::size_t, 6> widths{};
  for (const Cells& r : rows)
    for (std::size_t i = 0; i < r.size(); ++i) widths[i] = std::max(widths[i], width(r[i]));
  std::string text;
  for (const Cells& r : rows) {
    std::string line;
    for (std::size_t i = 0; i < r.size(); ++i)
      line += r[i] + std::string(widths[i] - width(r[i]) + 2, ' ');
    line.erase(line.find_last_not_of(' ') + 1);
    text += line + '\n';
  }
  return text;
}

bool counts(const Report& report, const CaseReport& c, std::size_t quantity) {
  const Expected& expected = c.made.expected;
  return expected.level_of(expected.quantities[quantity]) <= report.level;
}

Json number(double value) { return std::isnan(value) ? Json() : Json(value); }

Json quantity_json(const CaseReport& c, std::size_t i) {
  const Quantity& q = c.made.expected.quantities[i];
  const Judgement& j = c.judgements[i];
  Json json = {{"name", q.name},
               {"unit", q.unit},
               {"runs", q.used_runs()},
               {"measured", number(j.measured)}};
  const char* kind = !std::isnan(q.at_least)  ? "at least"
                     : !std::isnan(q.at_most) ? "at most"
                                              : "reference";
  json[kind] = number(reference(q));
  json["tolerance"] = number(tolerance(q));
  json["deviation"] = number(j.deviation);
  json["decides"] = q.decides;
  json["verdict"] = j.verdict == Verdict::miss         ? "miss"
                    : j.verdict == Verdict::known_miss ? "known miss"
                                                       : name(j.verdict);
  json["source"] = q.source;
  if (!j.note.empty()) json["note"] = j.note;
  return json;
}

Json run_json(const CaseReport& c, std::size_t i) {
  const RunSpec& spec = c.made.expected.runs[i];
  const RunResult& run = c.made.runs[i];
  Json json = {{"name", spec.name},
               {"level", spec.level == VerifyLevel::quick ? "quick" : "full"},
               {"state", name(run.state)},
               {"wall time [s]", number(run.wall)},
               {"arguments", run_words(c.made.expected, spec, run.directory)}};
  if (!run.error.empty()) json["error"] = run.error;
  return json;
}

}  // namespace

Count count(const Report& report) {
  Count n;
  for (const CaseReport& c : report.cases) {
    for (std::size_t i = 0; i < c.judgements.size(); ++i) {
      if (!counts(report, c, i)) continue;
      const Verdict v = c.judgements[i].verdict;
      ++(v == Verdict::pass          ? n.pass
         : v == Verdict::miss        ? n.miss
         : v == Verdict::known_miss  ? n.known_miss
         : v == Verdict::informative ? n.informative
                                     : n.not_run);
      n.wrong_input += c.judgements[i].wrong_input;
    }
    for (const RunResult& run : c.made.runs) {
      n.failed_runs += run.state == RunState::failed;
      if (run.finished()) n.wall += run.wall;
    }
  }
  return n;
}

Row row(const CaseReport& c, std::size_t i) {
  const Quantity& q = c.made.expected.quantities[i];
  const Judgement& j = c.judgements[i];
  return {c.made.expected.name, q.name,         with_unit(j.measured, q.unit), reference_text(q),
          deviation_text(q, j), name(j.verdict)};
}

std::string summary_line(const Report& report) {
  const Count n = count(report);
  std::string text = fmt::format("{} pass, {} miss, {} known misses, {} informative", n.pass,
                                 n.miss, n.known_miss, n.informative);
  if (n.not_run > 0) text += fmt::format(", {} not run", n.not_run);
  if (n.failed_runs > 0) text += fmt::format(", {} failed runs", n.failed_runs);
  text += fmt::format("; {:.0f} s of computing", n.wall);
  return report.interrupted ? text + "; interrupted, finished runs are kept" : text;
}

std::string terminal_table(const Report& report) {
  std::vector<Cells> rows = {{"case", "quantity", "measured", "reference", "deviation", "verdict"}};
  std::string notes;
  for (const CaseReport& c : report.cases)
    for (std::size_t i = 0; i < c.judgements.size(); ++i) {
      if (!counts(report, c, i)) continue;
      rows.push_back(cells(row(c, i)));
      if (!c.judgements[i].note.empty())
        notes += fmt::format("{}, {}: {}\n", c.made.expected.name,
                             c.made.expected.quantities[i].name, c.judgements[i].note);
    }
  return aligned(rows) + (notes.empty() ? "" : "\n" + notes);
}

Json report_json(const Report& report) {
  const Count n = count(report);
  Json json = {{"program", report.program},
               {"level", report.level == VerifyLevel::quick ? "quick" : "full"},
               {"interrupted", report.interrupted},
               {"pass", n.pass},
               {"miss", n.miss},
               {"known miss", n.known_miss},
               {"informative", n.informative},
               {"not run", n.not_run},
               {"failed runs", n.failed_runs},
               {"wall time of all runs [s]", n.wall},
               {"cases", Json::array()}};
  for (const CaseReport& c : report.cases) {
    Json entry = {{"name", c.made.expected.name}, {"title", c.made.expected.title}};
    for (std::size_t i = 0; i < c.made.runs.size(); ++i) entry["runs"].push_back(run_json(c, i));
    for (std::size_t i = 0; i < c.judgements.size(); ++i)
      entry["quantities"].push_back(quantity_json(c, i));
    json["cases"].push_back(entry);
  }
  return json;
}

}  // namespace washtub
