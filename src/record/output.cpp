#include "record/output.hpp"

#include <fmt/format.h>

#include <limits>

#include "io/summary.hpp"
#include "record/summarise.hpp"

namespace washtub {
namespace {

constexpr const char* axes[] = {"x", "y", "z"};

/// Whether the last node along an axis meets the first one; a periodic sheet goes on beyond the
/// box.
template <int D>
bool closes(const Sheet<D>& sheet, std::size_t axis) {
  return sheet.closed[axis] && sheet.period[axis].isZero(0);
}

template <int D>
bool has_rings(const Cloth<D>& cloth) {
  if constexpr (D == 2)
    for (const auto& group : cloth.groups)
      if (is_ring(group.sheet)) return true;
  return false;
}

}  // namespace

template <int D>
Output<D>::Output(const Simulation<D>& simulation, const Observer<D>& observer,
                  const std::string& directory)
    : simulation_(simulation),
      observer_(observer),
      directory_(directory),
      frames_(directory, simulation.grid().parallel(), D, fluid_grid(simulation.grid().mesh())) {
  const auto& block = simulation.grid().block();
  std::size_t cells = 1;
  for (int d = 0; d < D; ++d) cells *= static_cast<std::size_t>(block.count[d]);
  velocity_.resize(3 * cells);
  pressure_.resize(cells);
  solid_.resize(cells);
}

template <int D>
void Output<D>::start() {
  if (!simulation_.grid().parallel().root()) return;
  history_ = std::make_unique<History>(directory_ + "/history.csv", history_columns());
  if (simulation_.cloth().pieces() > 0)
    tracks_ = std::make_unique<History>(directory_ + "/tracks.csv", track_columns());
}

template <int D>
std::string Output<D>::go_on() {
  frames_.resume(frames_before_);
  if (!simulation_.grid().parallel().root()) return {};
  history_ = std::make_unique<History>(directory_ + "/history.csv", history_columns(), rows_);
  if (simulation_.cloth().pieces() > 0)
    tracks_ = std::make_unique<History>(directory_ + "/tracks.csv", track_columns(), rows_);
  if (history_->rows() == rows_ && frames_.frames() == frames_before_) return {};
  return fmt::format("{} of {} rows and {} of {} frames were lost with the interrupted run",
                     rows_ - history_->rows(), rows_, frames_before_ - frames_.frames(),
                     frames_before_);
}

template <int D>
void Output<D>::sync() const {
  if (history_) history_->sync();
  if (tracks_) tracks_->sync();
}

template <int D>
void Output<D>::state(Archive& archive) {
  int frames = frames_.frames();
  archive.value("rows", rows_);
  archive.value("frames", frames);
  if (archive.reading()) frames_before_ = frames;
}

template <int D>
std::vector<Column> Output<D>::history_columns() const {
  const std::string torque = D == 3 ? "N m" : "N";
  std::vector<Column> c = {{"time", "s"},      {"step", ""},
                           {"time step", "s"}, {"courant", ""},
                           {"divergence", ""}, {"pressure cycles", ""},
                           {"speed", "m/s"},   {"kinetic energy", D == 3 ? "J" : "J/m"}};
  for (const auto& s : simulation_.mapping().solids()) {
    if (s.drive.moving()) {
      c.push_back({s.name + " angle", "rad"});
      c.push_back({s.name + " speed", "rad/s"});
      c.push_back({s.name + " power", D == 3 ? "W" : "W/m"});
    }
    for (const char* part : {"", " friction", " pressure", " convection"})
      c.push_back({s.name + part + " torque", torque});
    for (int d = 0; d < D; ++d) c.push_back({s.name + " force " + axes[d], D == 3 ? "N" : "N/m"});
  }
  if (const auto& exact = simulation_.definition().exact)
    for (const char* which : {"largest", "rms"})
      c.push_back({which + std::string(" velocity error"), exact->relative ? "" : "m/s"});
  if (simulation_.cloth().pieces() == 0) return c;
  c.insert(c.end(), {{"stress", "Pa"},
                     {"membrane stress", "Pa"},
                     {"bending stress", "Pa"},
                     {"cloth radius", "m"},
                     {"cloth height", "m"},
                     {"largest strain", ""},
                     {"slip", "m/s"},
                     {"newton steps", ""}});
  for (const ProbeCase& probe : simulation_.definition().probes)
    for (int d = 0; d < D; ++d) c.push_back({probe.name + " " + axes[d], "m"});
  if (has_rings(simulation_.cloth())) c.push_back({"enclosed area", "m^2"});
  return c;
}

template <int D>
std::vector<Column> Output<D>::track_columns() const {
  std::vector<Column> c = {{"time", "s"}};
  for (int p = 1; p <= simulation_.cloth().pieces(); ++p) {
    c.push_back({fmt::format("piece {} r", p), "m"});
    c.push_back({fmt::format("piece {} z", p), "m"});
    c.push_back({fmt::format("piece {} stress", p), "Pa"});
  }
  return c;
}

template <int D>
void Output<D>::add_row(const Sample& sample) {
  ++rows_;
  if (!history_) return;
  const auto& step = simulation_.last();
  std::vector<double> row = {
      sample.time,     static_cast<double>(step.number),          step.dt,    step.courant,
      step.divergence, static_cast<double>(step.pressure.cycles), step.speed, step.kinetic};
  for (std::size_t s = 0; s < sample.solids.size(); ++s) {
    const auto& solid = sample.solids[s];
    if (simulation_.mapping().solids()[s].drive.moving())
      row.insert(row.end(), {solid.angle, solid.speed, -solid.torque * solid.speed});
    row.insert(row.end(), {solid.torque, solid.friction, solid.pressure, solid.convection});
    row.insert(row.end(), solid.force.begin(), solid.force.begin() + D);
  }
  if (simulation_.definition().exact)
    row.insert(row.end(), {sample.error.largest, sample.error.rms});
  if (tracks_) {
    row.insert(row.end(), {sample.stress.total, sample.stress.membrane, sample.stress.bending,
                           sample.centre[0], sample.centre[1], step.cloth.largest_strain,
                           step.cloth.slip, static_cast<double>(step.cloth.iterations)});
    for (const Vec<3>& x : sample.probes) row.insert(row.end(), x.begin(), x.begin() + D);
    if (has_rings(simulation_.cloth())) row.push_back(sample.enclosed_area);
    std::vector<double> tracks = {sample.time};
    for (std::size_t p = 0; p < sample.centres.size(); ++p)
      tracks.insert(tracks.end(),
                    {sample.centres[p][0], sample.centres[p][1], sample.pieces[p].total});
    tracks_->add(tracks);
  }
  history_->add(row);
}

/// Cell-centred values: means of the two faces along each axis.
template <int D>
void Output<D>::add_frame() {
  const auto& flow = simulation_.flow();
  const auto& block = simulation_.grid().block();
  const auto open = simulation_.mapping().open();
  std::size_t n = 0;
  for (int k = 0; k < block.planes(); ++k)
    for (int j = 0; j < block.rows(); ++j)
      for (int i = 0; i < block.width(); ++i, ++n) {
        const long p = block.row(j, k) + i;
        float open_faces = 0;
        for (int d = 0; d < D; ++d) {
          const long s = d == 0 ? 1 : block.stride[d];
          const double* u = flow.velocity()[d].data();
          velocity_[3 * n + static_cast<std::size_t>(d)] =
              static_cast<float>(0.5 * (u[p] + u[p + s]));
          open_faces = std::max({open_faces, open[d][p], open[d][p + s]});
        }
        pressure_[n] = static_cast<float>(flow.pressure().data()[p]);
        solid_[n] = 1 - open_faces;
      }
  Frame frame;
  frame.time = simulation_.time();
  for (int d = 0; d < 3; ++d) {
    frame.fluid.offset[d] = d < D ? block.offset[std::min(d, D - 1)] : 0;
    frame.fluid.count[d] = d < D ? block.count[std::min(d, D - 1)] : 1;
  }
  frame.fluid.velocity = velocity_;
  frame.fluid.pressure = pressure_;
  frame.fluid.solid = solid_;
  const auto& cloth = simulation_.cloth();
  for (const auto& g : cloth.groups)
    for (int p = 0; p < g.pieces; ++p) {
      const auto X = cloth.piece(g, p);
      const auto first = static_cast<std::size_t>(g.node(p, 0));
      const auto part = [&](const std::vector<double>& v) {
        return std::span<const double>(v).subspan(first, X.size());
      };
      frame.cloth.push_back({g.sheet.extent,
                             std::span<const double>(X.front().data(), X.size() * D),
                             part(observer_.membrane()),
                             part(observer_.bending()),
                             part(observer_.total()),
                             {closes(g.sheet, 0), closes(g.sheet, 1)}});
    }
  for (const auto& s : simulation_.mapping().solids())
    frame.solids.push_back({s.name, s.drive.angle(frame.time)});
  frames_.write(frame);
}

template <int D>
void Output<D>::write_summary(const std::string& outcome, double wall_time) const {
  if (!simulation_.grid().parallel().root()) return;
  auto summary = summarise(simulation_, observer_, wall_time);
  summary["run"]["outcome"] = outcome;
  summary["run"]["frames"] = frames_.frames();
  washtub::write_summary(directory_ + "/summary.json", summary);
}

template class Output<2>;
template class Output<3>;

}  // namespace washtub
