#pragma once
#include <optional>
#include <string>
#include <vector>

#include "verify/level.hpp"

namespace washtub {

/// What the command line gives of a case.
struct CaseArguments {
  std::string path;
  std::vector<std::string> settings;  ///< "key=value" of --set
};

struct RunArguments {
  CaseArguments input;
  std::string directory;     ///< of the results; "" = out/<name of the case>
  std::optional<int> ranks;  ///< as many as there are cores where not given
  bool force = false;
  std::vector<std::string> all;  ///< the whole command line
};

/// What `washtub modes` asks for.
struct ModesArguments {
  CaseArguments input;
  int count = 5;     ///< lowest frequencies of every group
  std::string file;  ///< JSON to write; "" = none
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

/// Every command returns the exit code.
int command_run(const RunArguments& arguments);
int command_check(const CaseArguments& arguments);
int command_reference();
int command_modes(const ModesArguments& arguments);
int command_verify(const VerifyArguments& arguments);

}  // namespace washtub
