#pragma once
#include <string>

namespace washtub {

/// Makes report.html of a run that has ended, however it ended; nothing where it has no history.
/// What goes wrong is told on stderr and in log.txt. Returns whether all went well. To be called by
/// one process.
bool report_run(const std::string& directory);

}  // namespace washtub
