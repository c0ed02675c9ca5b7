#pragma once
#include <memory>
#include <nlohmann/json.hpp>
#include <vector>

#include "report/chunk.hpp"
#include "report/fields.hpp"

namespace washtub {

/// The water of one frame after another, each quantised and deflated as it comes.
class FieldStream {
 public:
  /// `frame`: its number among the frames shown.
  void add(std::size_t frame, const Lattice& water);

  std::size_t frames() const { return frames_.size(); }
  /// Ends the streams. Returns "frames", "velocity", "vorticity" and "solid" of a FieldIndex in
  /// viewer/src/model/bundle.ts.
  nlohmann::ordered_json finish(Chunks& chunks);

 private:
  /// Velocity or vorticity.
  struct Companded {
    Deflater values;
    std::vector<double> largest;
    void add(const std::vector<float>& frame);
    nlohmann::ordered_json finish(Chunks& chunks);
  };

  std::vector<std::size_t> frames_;
  Companded velocity_, vorticity_;
  Deflater solid_;
  bool plane_ = false;
};

}  // namespace washtub
