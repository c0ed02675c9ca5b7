#pragma once
#include <map>
#include <nlohmann/json.hpp>
#include <optional>

#include "report/chunk.hpp"
#include "report/thinning.hpp"
#include "report/water.hpp"

namespace washtub {

/// Adds the frames that the thinning leaves to the chunks. Returns the FrameIndex of
/// viewer/src/model/bundle.ts.
nlohmann::ordered_json frames_index(const FrameSet& frames, std::optional<Water>& water,
                                    const Thinning& thinning, Chunks& chunks);

/// About how much of a page the frames take, found without making them all.
class FrameEstimate {
 public:
  FrameEstimate(const FrameSet& frames, std::optional<Water>& water);

  double bytes(const Thinning& thinning);

 private:
  std::size_t frames_;
  std::optional<Water>& water_;
  double cloth_ = 0;                  ///< of all frames [bytes]
  std::map<int, double> water_each_;  ///< per frame, by how often it is coarsened [bytes]
};

}  // namespace washtub
