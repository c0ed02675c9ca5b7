#pragma once
#include <string>

#include "io/lock.hpp"

namespace washtub {

/// out/<name of the case>: its file's name, or its folder's where the file is called case.toml.
std::string default_directory(const std::string& case_path);

/// Makes a folder for the results of many runs. @throws InputError where it cannot be written
void make_results_folder(const std::string& directory);

/// @throws InputError if the results would take the place of the case file itself
void protect_case(const std::string& case_path, const std::string& directory);

/// Removes half-written files that a killed run has left, while no other run writes there.
void remove_unfinished(const std::string& directory);

/// On return the directory exists, can be written, and holds no results of another run; with
/// `force` those that it held are gone. No other run can write there while the lock lives.
/// @throws InputError
[[nodiscard]] DirectoryLock prepare_directory(const std::string& directory, bool force);

}  // namespace washtub
