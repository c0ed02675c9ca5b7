#pragma once
#include <cstddef>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "report/run_record.hpp"

namespace washtub {

/// What a page is made of.
struct PageContent {
  std::string program;                          ///< "washtub 0.1.0"
  std::vector<RunRecord> runs;                  ///< one for a report, several for a comparison
  nlohmann::ordered_json comparison = nullptr;  ///< as in viewer/src/model/bundle.ts
  nlohmann::ordered_json ensemble = nullptr;    ///< likewise, where the runs are its members
};

/// What was written.
struct PageSize {
  std::size_t bytes = 0;
  std::size_t frames = 0;          ///< of all runs together, as shown
  std::vector<std::string> notes;  ///< sentences on what is missing and what was left out to fit
};

/// Writes one self-contained HTML page, thinned as far as needed to stay within `limit` bytes,
/// which the runs share. An older file is replaced at once.
/// @throws InputError with the smallest possible size where the limit cannot be kept
/// @throws RunError where the file cannot be written
PageSize write_page(const std::string& path, const PageContent& content, std::size_t limit);

}  // namespace washtub
