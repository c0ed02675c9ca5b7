#pragma once
#include <string>

namespace washtub {

/// Makes report.html of a run that has ended, however it ended; nothing where it has no history.
/// What goes wrong is told on stderr and in log.txt only. To be called by one process.
void report_run(const std::string& directory);

}  // namespace washtub
