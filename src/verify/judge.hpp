#pragma once
#include <string>
#include <vector>

#include "verify/runs.hpp"

namespace washtub {

enum class Verdict {
  pass,
  miss,
  known_miss,   ///< a known miss, to the same side and no more than a tenth worse
  informative,  ///< the quantity does not decide
  not_run
};

std::string name(Verdict verdict);

/// A quantity beside what it should be. NaN stands for what there is not.
struct Judgement {
  double measured = std::nan("");
  double deviation = std::nan("");  ///< measured less reference
  Verdict verdict = Verdict::not_run;
  std::string note;          ///< why there is no measured value
  bool wrong_input = false;  ///< expected.toml asks for what the run does not give
};

/// Verdict on a measured value.
Judgement judge(const Quantity& quantity, double measured);

/// The value, or the bound where there is one in its place.
double reference(const Quantity& quantity);
/// Largest distance from the value that passes; NaN where none is given.
double tolerance(const Quantity& quantity);

/// log(e_1/e_2) / log(refinement) of two values about `exact`, or of the differences of three; NaN
/// where the second error vanishes or the differences have two signs.
double observed_order(const std::vector<double>& values, double refinement, double exact);

/// What a finished run gives for a number. @throws InputError where it does not have it
double measured_number(const Measured& what, const RunResult& run);

/// One judgement per quantity. Where a run failed its quantities are misses, where one was not made
/// they are not run.
std::vector<Judgement> judge(const CaseRuns& c);

}  // namespace washtub
