#pragma once
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "report/chunk.hpp"
#include "report/run_record.hpp"

namespace washtub {

/// A run as a page carries it.
struct RunBundle {
  nlohmann::ordered_json index;    ///< RunIndex of viewer/src/model/bundle.ts
  std::size_t frames = 0;          ///< shown
  std::size_t bytes = 0;           ///< that index and chunks take in the page
  std::vector<std::string> notes;  ///< sentences on what is missing and what was left out to fit
};

/// Makes the index of a run and adds its data to the chunks, thinned as far as needed to take
/// `room` bytes at most. More than that only where everything that can be left out is left out.
RunBundle bundle(const RunRecord& run, Chunks& chunks, std::size_t room);

}  // namespace washtub
