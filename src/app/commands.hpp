#pragma once
#include <optional>
#include <string>
#include <vector>

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

/// Every command returns the exit code.
int command_run(const RunArguments& arguments);
int command_check(const CaseArguments& arguments);
int command_reference();

}  // namespace washtub
