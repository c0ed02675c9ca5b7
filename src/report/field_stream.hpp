#pragma once
#include <list>
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
  /// Ends the streams. Returns "frames", "velocity", "vorticity", "solid" and "scalars" of a
  /// FieldIndex in viewer/src/model/bundle.ts.
  nlohmann::ordered_json finish(Chunks& chunks);

 private:
  /// Velocity or vorticity.
  struct Companded {
    Deflater values;
    std::vector<double> largest;
    void add(const std::vector<float>& frame);
    nlohmann::ordered_json finish(Chunks& chunks);
  };

  /// Another field.
  struct Scalar {
    explicit Scalar(const FieldDescription& about) : field(about) {}
    FieldDescription field;
    Companded stream;
  };
  /// Starts the streams of the scalars that the first frame has.
  void add_scalars(const Lattice& water);

  std::vector<std::size_t> frames_;
  Companded velocity_, vorticity_;
  std::list<Scalar> scalars_;
  Deflater solid_;
  bool plane_ = false;
};

}  // namespace washtub
