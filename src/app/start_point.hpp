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

/// How a case differs from the one whose results a directory holds, as sentences, but for what may
/// change when a run goes on; none where it holds no case.
std::vector<std::string> differing_case(const std::string& directory, const Case& whole);

}  // namespace washtub
