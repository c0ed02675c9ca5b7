#pragma once
#include <string>
#include <vector>

#include "app/commands.hpp"
#include "io/lock.hpp"
#include "record/run.hpp"

namespace washtub {

/// Where the results of a run go, and the case with them where a run goes on that is named by its
/// directory alone.
void settle_directory(RunArguments& arguments);

/// Makes the directory of a new run ready, or finds the checkpoint to go on from; sets
/// options.resumed and options.developed. What there is to say goes to stderr. No other run can
/// write to the directory while the lock lives.
/// @throws InputError where there is nothing to start from, or a checkpoint is of another case
[[nodiscard]] DirectoryLock prepare_start(const RunArguments& arguments, const Case& whole,
                                          RunOptions& options);

/// Whether a directory holds a run that has reached its end.
bool is_complete(const std::string& directory);

/// How a case differs from the one whose results a directory holds, as sentences; none where it
/// holds no case. What may change when a run goes on does not count: what it writes, how long it
/// runs, and, where that has not reached its end, what the reasons for which a run gives up ask to
/// change.
std::vector<std::string> differing_case(const std::string& directory, const Case& whole);

/// Whether a run can go on to what a case says now from the newest checkpoint of a directory, if
/// there is one.
/// @throws InputError where it cannot
void check_going_on(const std::string& directory, const Case& whole);

}  // namespace washtub
