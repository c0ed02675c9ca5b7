#pragma once
#include <optional>
#include <string>
#include <vector>

#include "verify/level.hpp"

namespace washtub {

constexpr const char* program_name = "washtub " WASHTUB_VERSION;

/// What the command line gives of a case.
struct CaseArguments {
  std::string path;
  std::vector<std::string> settings;  ///< "key=value" of --set
};

/// What `washtub check` asks for.
struct CheckArguments {
  CaseArguments input;
  std::optional<int> ranks;      ///< as of a run
  bool forecast = true;          ///< the run is begun, to foresee what it takes
  std::vector<std::string> all;  ///< the whole command line
};

struct RunArguments {
  CaseArguments input;
  std::string directory;     ///< of the results; "" = out/<name of the case>
  std::optional<int> ranks;  ///< as many as there are free cores where not given
  bool force = false;
  bool resume = false;           ///< go on with an interrupted run
  std::string from;              ///< checkpoint whose water and cloth are the start; "" = none
  bool report = true;            ///< a page is made at the end
  std::vector<std::string> all;  ///< the whole command line
};

struct ReferenceArguments {
  bool output = false;  ///< of the results instead of the case file
  bool schema = false;  ///< the JSON schema of case files, for editors
};

/// What `washtub modes` asks for.
struct ModesArguments {
  CaseArguments input;
  int count = 5;     ///< lowest frequencies of every group
  std::string file;  ///< JSON to write; "" = none
};

/// What `washtub bench` asks for.
struct BenchArguments {
  int ranks = 1;
  std::string filter;            ///< regular expression of what is timed; "" = all
  std::string file;              ///< JSON to write; "" = none
  std::string compare;           ///< an earlier one; "" = none
  std::vector<std::string> all;  ///< the whole command line
};

struct VerifyArguments {
  std::vector<std::string> names;  ///< of cases; empty = all
  VerifyLevel level = VerifyLevel::quick;
  std::string directory = "out/verification";
  std::string cases;         ///< folder of the cases; "" = the program's own
  std::optional<int> jobs;   ///< runs at once; as many as there are cores where not given
  bool list = false;         ///< only name the cases
  bool force = false;        ///< finished runs are done again
  bool allow_known = false;  ///< known misses leave the exit code alone
};

struct ReportArguments {
  std::string directory;       ///< of the run
  std::string file;            ///< page to write; "" = report.html in the run's directory
  std::string size = "20 MB";  ///< largest size of the page
};

struct CompareArguments {
  std::vector<std::string> directories;  ///< of the runs; the others are held against the first
  std::string file = "comparison.html";  ///< page to write
  std::string size = "20 MB";            ///< largest size of the page
};

struct EnsembleArguments {
  CaseArguments input;
  std::string seeds = "5";     ///< how many, or "6-10"
  std::string directory;       ///< of the members; "" = out/<name of the case>-ensemble
  std::optional<int> jobs;     ///< runs at once; as many as the cores take where not given
  int ranks = 1;               ///< of each run
  bool force = false;          ///< finished and unfinished members are made anew
  std::string size = "20 MB";  ///< largest size of the page
};

struct MovieArguments {
  std::string directory;  ///< of the run
  std::string file;       ///< to write; "" = movie.mp4 in the run's directory
  std::string size = "1280x720";
  int fps = 30;
  double speed = 1;           ///< seconds of the run in one of the movie
  std::string from, to;       ///< times with units; "" = the whole run
  std::string colour, slice;  ///< as in the page's view; "" = as the page begins
};

/// Every command returns the exit code.
int command_run(RunArguments arguments);
int command_check(const CheckArguments& arguments);
int command_reference(const ReferenceArguments& arguments);
/// Of one fabric, or of all where the name is empty.
int command_fabrics(const std::string& name);
int command_modes(const ModesArguments& arguments);
int command_bench(const BenchArguments& arguments);
int command_verify(const VerifyArguments& arguments);
int command_report(const ReportArguments& arguments);
int command_compare(const CompareArguments& arguments);
int command_ensemble(const EnsembleArguments& arguments);
int command_movie(const MovieArguments& arguments);

}  // namespace washtub
