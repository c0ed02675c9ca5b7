#include "record/output.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>

#include "base/error.hpp"
#include "io/agree.hpp"
#include "io/file.hpp"
#include "io/summary.hpp"
#include "io/table.hpp"
#include "record/fields.hpp"
#include "record/summarise.hpp"

namespace washtub {
namespace {

/// Whether the last node along an axis meets the first one; a periodic sheet goes on beyond the
/// box.
template <int D>
bool closes(const Sheet<D>& sheet, std::size_t axis) {
  return sheet.closed[axis] && sheet.period[axis].isZero(0);
}

/// The rows that this run has written.
CsvTable written(const std::string& path) try {
  return {path, sound_rows(read_file(path)).text};
} catch (const InputError& error) {
  throw RunError(error.what());
}

}  // namespace

template <int D>
Output<D>::Output(const Simulation<D>& simulation, const Observer<D>& observer,
                  const std::string& directory)
    : simulation_(simulation),
      observer_(observer),
      directory_(directory),
      history_columns_(history_columns(simulation.definition())),
      track_columns_(track_columns(simulation.definition())),
      frames_(directory, simulation.grid().parallel(), D, fluid_grid(simulation.grid().mesh())) {}

template <int D>
void Output<D>::start() {
  if (!simulation_.grid().parallel().root()) return;
  history_ = std::make_unique<History>(directory_ + "/history.csv", header(history_columns_));
  if (!track_columns_.empty())
    tracks_ = std::make_unique<History>(directory_ + "/tracks.csv", header(track_columns_));
}

template <int D>
std::string Output<D>::go_on() {
  std::vector<std::string> lost;
  const auto count = [&](int& before, int now, const std::string& what) {
    if (now != before) lost.push_back(fmt::format("{} of {} {}", before - now, before, what));
    before = now;
  };
  frames_.resume(frame_count_);
  count(frame_count_, frames_.frames(), "frames");
  const Parallel& parallel = simulation_.grid().parallel();
  const auto open = [&](const char* name, const std::vector<RecordColumn>& columns, int& rows) {
    std::unique_ptr<History> file;
    if (parallel.root())
      file = std::make_unique<History>(fmt::format("{}/{}.csv", directory_, name), header(columns),
                                       rows);
    int left = file ? static_cast<int>(file->rows()) : 0;
    MPI_Bcast(&left, 1, MPI_INT, 0, parallel.comm());
    count(rows, left, fmt::format("rows of {}.csv", name));
    return file;
  };
  history_ = open("history", history_columns_, rows_);
  if (!track_columns_.empty()) tracks_ = open("tracks", track_columns_, track_rows_);
  if (lost.empty()) return {};
  return fmt::format("{} are missing", fmt::join(lost, ", "));
}

template <int D>
std::string Output<D>::sync() const {
  try {
    if (history_) history_->sync();
    if (tracks_) tracks_->sync();
  } catch (const RunError& error) {
    return error.what();
  }
  return {};
}

template <int D>
void Output<D>::state(Archive& archive) {
  archive.value("rows", rows_);
  archive.value("rows of tracks", track_rows_);
  archive.value("frames", frame_count_);
}

template <int D>
void Output<D>::add_row(const Sample& sample) {
  std::string reason;
  try {
    if (history_) history_->add(row(history_columns_, sample));
    if (tracks_) tracks_->add(row(track_columns_, sample));
  } catch (const RunError& error) {
    reason = error.what();
  }
  agree(simulation_.grid().parallel(), reason);
  ++rows_;
  if (!track_columns_.empty()) ++track_rows_;
}

/// Values of this rank's cells.
template <int D>
FluidBlock Output<D>::water() {
  const auto& block = simulation_.grid().block();
  FluidBlock fluid;
  for (int d = 0; d < 3; ++d) {
    fluid.offset[d] = d < D ? block.offset[std::min(d, D - 1)] : 0;
    fluid.count[d] = d < D ? block.count[std::min(d, D - 1)] : 1;
  }
  const auto& fields = water_fields<D>();
  water_.resize(fields.size());
  for (std::size_t f = 0; f < fields.size(); ++f) {
    const auto width = static_cast<std::size_t>(fields[f].field.components);
    auto& values = water_[f];
    values.clear();
    for (int k = 0; k < block.planes(); ++k)
      for (int j = 0; j < block.rows(); ++j)
        for (long p = block.row(j, k), end = p + block.width(); p < end; ++p) {
          values.resize(values.size() + width);
          fields[f].take(simulation_, p, &values[values.size() - width]);
        }
    fluid.fields.push_back({fields[f].field, values});
  }
  return fluid;
}

template <int D>
std::vector<ClothPiece> Output<D>::cloth() const {
  std::vector<ClothPiece> pieces;
  const auto& cloth = simulation_.cloth();
  for (const auto& g : cloth.groups)
    for (int p = 0; p < g.pieces; ++p) {
      const auto X = cloth.piece(g, p);
      ClothPiece piece{g.sheet.extent,
                       std::span<const double>(X.front().data(), X.size() * D),
                       {},
                       {closes(g.sheet, 0), closes(g.sheet, 1)}};
      for (const auto& field : cloth_fields<D>())
        piece.values.push_back(std::span<const double>((observer_.*field.values)())
                                   .subspan(static_cast<std::size_t>(g.node(p, 0)), X.size()));
      pieces.push_back(std::move(piece));
    }
  return pieces;
}

/// On return all values of the water are finite on all ranks.
template <int D>
void Output<D>::check_finite(const FluidBlock& fluid) const {
  double wrong = 0;  // number of the last such field, from 1
  for (std::size_t f = 0; f < fluid.fields.size(); ++f)
    for (const float value : fluid.fields[f].values)
      if (!std::isfinite(value)) wrong = static_cast<double>(f + 1);
  wrong = simulation_.grid().parallel().max(wrong);
  if (wrong > 0)
    throw RunError(fmt::format(
        "t = {:.6g} s: the field {} of the water is not finite everywhere, so that its frame was "
        "not "
        "written; try a smaller time.step or time.cfl",
        simulation_.time(), fluid.fields[static_cast<std::size_t>(wrong) - 1].field.label));
}

template <int D>
void Output<D>::add_frame() {
  Frame frame{simulation_.time(), water(), {}, cloth(), {}};
  check_finite(frame.fluid);
  for (const auto& field : cloth_fields<D>()) frame.cloth_fields.push_back(field.field);
  const Crossings& crossings = observer_.quality().crossings;
  if (crossings.edges > 0)
    frame.numbers = {{"edges of cloth", static_cast<double>(crossings.edges)},
                     {"edges through other pieces", static_cast<double>(crossings.others)},
                     {"edges through their own piece", static_cast<double>(crossings.own)}};
  for (const auto& s : simulation_.definition().solids)
    frame.solids.push_back({s.name, s.drive.angle(frame.time)});
  frames_.write(frame);
  ++frame_count_;
}

template <int D>
void Output<D>::write_summary(const std::string& outcome, double wall_time) const {
  const Parallel& parallel = simulation_.grid().parallel();
  if (!parallel.root()) return;
  const auto& last = simulation_.last();
  const RunEnd end{outcome,
                   last.time,
                   last.number,
                   parallel.size(),
                   wall_time,
                   frames_.frames(),
                   observer_.extremes(),
                   observer_.quality(),
                   simulation_.clock().spent()};
  const CsvTable history = written(directory_ + "/history.csv");
  const auto tracks = tracks_ ? std::optional(written(directory_ + "/tracks.csv")) : std::nullopt;
  washtub::write_summary(directory_ + "/summary.json",
                         summarise(simulation_.definition(), end, observer_.cloth(), history,
                                   tracks ? &*tracks : nullptr));
}

template class Output<2>;
template class Output<3>;

}  // namespace washtub
