#pragma once
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "verify/figures.hpp"
#include "verify/judge.hpp"

namespace washtub {

/// A case with all that came out of it; judgements and figures in the order of `made.expected`.
struct CaseReport {
  CaseRuns made;
  std::vector<Judgement> judgements;
  std::vector<Drawn> figures;
};

struct Report {
  std::string program;  ///< name and version
  VerifyLevel level = VerifyLevel::quick;
  bool interrupted = false;
  std::vector<CaseReport> cases;
};

struct Count {
  int pass = 0, miss = 0, known_miss = 0, informative = 0, not_run = 0, failed_runs = 0,
      wrong_input = 0;
  double wall = 0;  ///< of all finished runs together [s]
};

/// Quantities whose runs are of a higher level than the report's do not count.
Count count(const Report& report);

/// What the cells of a row show; the terminal and the page print the same.
struct Row {
  std::string name, quantity, measured, reference, deviation, verdict;
};
Row row(const CaseReport& c, std::size_t quantity);

/// One line: "12 pass, 1 miss, 2 known misses, 3 informative; 63 s of computing".
std::string summary_line(const Report& report);

/// The table for a terminal, one line per quantity that counts, and what went wrong below it.
std::string terminal_table(const Report& report);

nlohmann::ordered_json report_json(const Report& report);

}  // namespace washtub
