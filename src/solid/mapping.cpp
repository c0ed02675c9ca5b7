#include "solid/mapping.hpp"

#include <algorithm>
#include <cmath>

#include "base/error.hpp"

namespace washtub {
namespace {

constexpr double rebase_after = 32;  // [rad] of travel, so that single precision keeps its digits

constexpr double deepest_push = 4;  // cells that the cloth's force reaches into a solid

constexpr std::uint8_t nobody = 255;  // owner of the faces on the sides of the box

/// Cells of the block whose faces lie within `reach` of the axis and between two heights.
template <int D>
CellBox<D> cells_within(const Grid<D>& grid, const Vec<D>& lower, const Vec<D>& upper) {
  CellBox<D> box;
  const auto& mesh = grid.mesh();
  const auto& block = grid.block();
  for (int d = 0; d < D; ++d) {
    const double a = std::floor((lower[d] - mesh.lower[d]) / mesh.h[d]) - 1;
    const double b = std::ceil((upper[d] - mesh.lower[d]) / mesh.h[d]) + 1;
    const double n = block.count[d];
    box.lower[d] = static_cast<int>(std::clamp(a - block.offset[d], 0.0, n));
    box.upper[d] = static_cast<int>(std::clamp(b - block.offset[d], 0.0, n));
  }
  return box;
}

constexpr int look = 16;  // faces of a row that are asked at once whether to look at them again
static_assert(look <= Block<3>::pad);
constexpr float never = 1e30F;

/// Least of `look` values.
float earliest(const float* values) {
  float least = never;
#pragma omp simd reduction(min : least)
  for (int i = 0; i < look; ++i) least = std::min(least, values[i]);
  return least;
}

/// How far from a surface a face in the water can be and still be closed in part.
template <int D>
double reach_outside(const Heaviside& heaviside, const WallLayer<D>& layer, const Mesh<D>& mesh) {
  switch (heaviside.kind) {
    case Heaviside::Kind::smooth:
      return heaviside.gamma;
    case Heaviside::Kind::gradual:
      return layer.reach();
    default:
      return heaviside.shift * mesh.h.sum();
  }
}

}  // namespace

/// What a turning solid can reach, `margin` around it included.
template <int D>
typename DomainMapping<D>::Reach DomainMapping<D>::sweep(const Grid<D>& grid, const Solid& solid,
                                                         double margin) {
  const Bounds b = solid.shape.bounds();
  const double x = std::max(std::abs(b.lower[0]), std::abs(b.upper[0]));
  const double y = std::max(std::abs(b.lower[1]), std::abs(b.upper[1]));
  const double radius = std::hypot(x, y) + margin;
  Vec<D> lower, upper;
  for (int d = 0; d < D; ++d) {
    lower[d] = solid.centre[d] + (d < 2 ? -radius : b.lower[2] - margin);
    upper[d] = solid.centre[d] + (d < 2 ? radius : b.upper[2] + margin);
  }
  return {cells_within(grid, lower, upper), radius};
}

template <int D>
DomainMapping<D>::DomainMapping(const Grid<D>& grid, std::vector<Solid> solids,
                                const Heaviside& heaviside)
    : grid_(grid),
      solids_(std::move(solids)),
      heaviside_(heaviside),
      layer_(grid),
      reach_outside_(washtub::reach_outside(heaviside, layer_, grid.mesh())),
      reach_inside_(heaviside.gamma) {
  if (solids_.size() >= nobody) throw InputError("too many solids: at most 254");
  const auto n = static_cast<std::size_t>(grid.block().size);
  for (int d = 0; d < D; ++d) {
    open_[d] = Storage<float>(n);
    expiry_[d] = Storage<float>(n);
    expiry_[d].fill(never);
    owner_[d] = Storage<std::uint8_t>(n);
  }
  for (int d = 0; d < D; ++d) {
    swept_.emplace_back(grid, d);
    resting_.emplace_back(grid, d);
    held_.emplace_back(grid.block().rows() * grid.block().planes());
  }
  CellBox<D> whole;
  whole.upper = grid.block().count;
  moving_planes_ = {grid.block().planes(), 0};
  for (const auto& solid : solids_) {
    reach_.push_back(solid.drive.moving() ? sweep(grid, solid, reach_outside_) : Reach{});
    const auto& cells = reach_.back().cells;
    if (cells.empty()) continue;
    moving_planes_[0] = std::min(moving_planes_[0], cells.lower[D - 1]);
    moving_planes_[1] = std::max(moving_planes_[1], cells.upper[D - 1]);
  }
  if (moving_planes_[0] >= moving_planes_[1]) moving_planes_ = {0, 0};
  pose();
  evaluate(whole, true);
  changed_.clear();
  close_sides();
  exchange();
  find_surface();
  for (auto& held : held_) held.update();
}

/// Whether a solid that moves can come to a face.
template <int D>
bool DomainMapping<D>::swept(const Vec<D>& x, const Index<D>& cell) const {
  for (std::size_t s = 0; s < solids_.size(); ++s) {
    const Vec<2> arm = x.template head<2>() - solids_[s].centre.template head<2>();
    if (reach_[s].cells.contains(cell) && arm.norm() <= reach_[s].radius) return true;
  }
  return false;
}

/// Takes a face in a solid to the lists, if what acts at the surface can come to it: cloth pushes
/// as far as its delta function reaches.
template <int D>
void DomainMapping<D>::list_surface(int d, const Index<D>& cell) {
  const Vec<D> x = grid_.position(cell, d);
  const int owner = owner_[d][grid_.block().at(cell)];
  if (swept(x, cell))
    swept_[d].add(cell);
  else if (poses_[owner].psi(in_space<D>(x)) < deepest_push * grid_.mesh().h.maxCoeff())
    resting_[d].add(cell);
}

/// All faces in solids.
template <int D>
void DomainMapping<D>::find_surface() {
  const auto& block = grid_.block();
  for (int d = 0; d < D; ++d) {
    swept_[d].clear();
    resting_[d].clear();
    for (int k = 0; k < block.planes(); ++k)
      for (int j = 0; j < block.rows(); ++j)
        for (int i = 0; i < block.width(); ++i) {
          const long p = block.row(j, k) + i;
          if (open_[d][p] >= 1 || owner_[d][p] == nobody) continue;
          Index<D> cell{};
          cell[0] = i;
          if constexpr (D == 3) cell[1] = j;
          cell[D - 1] = k;
          list_surface(d, cell);
        }
    swept_[d].update(open_[d].data());
    resting_[d].update(open_[d].data());
  }
}

template <int D>
std::array<const HeldFaces*, D> DomainMapping<D>::held() const {
  std::array<const HeldFaces*, D> held;
  for (int d = 0; d < D; ++d) held[d] = &held_[d];
  return held;
}

template <int D>
double DomainMapping<D>::content(float open) const {
  return heaviside_.kind == Heaviside::Kind::smooth ? open : 1;
}

/// Of the face of a cell along axis d, with psi at its centre; also how it is held.
template <int D>
float DomainMapping<D>::open_fraction(const Vec<3>& x, double psi, int d, const Index<D>& cell,
                                      int owner) {
  if (heaviside_.kind == Heaviside::Kind::sharp) return heaviside_.open_fraction(psi);
  HeldFace face{};
  face.p = grid_.block().at(cell);
  face.row = grid_.block().row_index(D == 3 ? cell[1] : 0, cell[D - 1]);
  face.place = cell[0];
  if (open_[d][face.p] < 1) held_[d].look(face.p);
  if (psi <= -reach_outside_) return 1;
  float open = 0;
  if (heaviside_.kind == Heaviside::Kind::smooth) {
    open = heaviside_.open_fraction(psi);
    face.share = open > 0 ? 1 - open : 0;
    face.wall = poses_[owner].velocity(x)[d];
  } else if (psi < 0) {
    open = layer_.close(poses_[owner], x, psi, d, face);
  }
  if (open > 0 && open < 1) held_[d].hold(face);
  return open;
}

/// What the sharp mapping adds to psi, where it can decide.
template <int D>
double DomainMapping<D>::outset(const SolidPose& solid, const Vec<3>& x, double psi) const {
  if (heaviside_.shift == 0 || psi > 0 || psi < -reach_outside_) return 0;
  const auto& h = grid_.mesh().h;
  const Vec<3> n = solid.normal(x, 0.5 * h.minCoeff());
  double width = 0;
  for (int d = 0; d < D; ++d) width += std::abs(n[d]) * h[d];
  return heaviside_.shift * width;
}

/// Looks again at the faces of a row whose guarantee has run out: psi of a turning solid changes at
/// most by the lever arm times the angle it turns.
template <int D>
void DomainMapping<D>::evaluate_row(int d, int j, int k, int i0, int i1, bool all) {
  const auto& block = grid_.block();
  const long p = block.row(j, k);
  float* open = open_[d].data() + p;
  float* expiry = expiry_[d].data() + p;
  std::uint8_t* owner = owner_[d].data() + p;
  const auto now = static_cast<float>(travel_);
  Index<D> cell{};
  if constexpr (D == 3) cell[1] = j;
  cell[D - 1] = k;
  if (d > 0 && cell[d] == 0 && grid_.at_side(d, 0)) return;  // a side of the box, always closed
  if (d == 0 && grid_.at_side(0, 0)) i0 = std::max(i0, 1);
  for (int i = i0; i < i1; ++i) {
    if (!all && i % look == 0 && earliest(expiry + i) > now) {
      i += look - 1;
      continue;
    }
    if (!all && expiry[i] > now) continue;
    cell[0] = i;
    const Vec<3> x = in_space<D>(grid_.position(cell, d));
    double largest = -1e300, turn = 1e30;
    for (std::size_t s = 0; s < solids_.size(); ++s) {
      const double value = poses_[s].psi(x);
      const double seen = value + outset(poses_[s], x, value);
      if (seen > largest) largest = seen, owner[i] = static_cast<std::uint8_t>(s);
      if (!solids_[s].drive.moving()) continue;
      const double dx = x[0] - solids_[s].centre[0], dy = x[1] - solids_[s].centre[1];
      const double lever = std::sqrt(dx * dx + dy * dy);
      const double margin = value > 0 ? value - reach_inside_ : -value - reach_outside_;
      turn = std::min(turn, margin / (lever + 1e-30));
    }
    expiry[i] = static_cast<float>(travel_ + std::clamp(0.999 * turn, 0.0, 1e6));
    const float fresh = open_fraction(x, largest, d, cell, owner[i]);
    if (fresh == open[i]) continue;
    changed_.push_back({d, owner[i], p + i, grid_.position(cell, d), open[i], fresh});
    if (open[i] >= 1) swept_[d].add(cell);
    if (fresh >= 1) swept_[d].release();
    open[i] = fresh;
    change_.any = true;
  }
}

template <int D>
void DomainMapping<D>::evaluate(const CellBox<D>& box, bool all) {
  if (box.empty()) return;
  for (int d = 0; d < D; ++d)
    for (int k = box.lower[D - 1]; k < box.upper[D - 1]; ++k) {
      const int j0 = D == 3 ? box.lower[1] : 0, j1 = D == 3 ? box.upper[1] : 1;
      for (int j = j0; j < j1; ++j) evaluate_row(d, j, k, box.lower[0], box.upper[0], all);
    }
}

/// Faces on the sides of the box are closed; their velocity is the side's.
template <int D>
void DomainMapping<D>::close_sides() {
  const auto& block = grid_.block();
  for (int d = 0; d < D; ++d)
    for (int side = 0; side < 2; ++side) {
      if (!grid_.at_side(d, side)) continue;
      const int at = side == 0 ? 0 : block.count[d];
      Index<D> c{};
      for (int k = 0; k < (d == D - 1 ? 1 : block.planes()); ++k)
        for (int j = 0; j < (d == 1 || D == 2 ? 1 : block.rows()); ++j)
          for (int i = 0; i < (d == 0 ? 1 : block.width()); ++i) {
            c[0] = i;
            if constexpr (D == 3) c[1] = j;
            c[D - 1] = k;
            c[d] = at;
            open_[d][block.at(c)] = 0;
            owner_[d][block.at(c)] = nobody;
          }
    }
}

/// Ghosts of the open fractions and of their owners.
template <int D>
void DomainMapping<D>::exchange() {
  grid_.halo().exchange(open_);
  grid_.halo().exchange(owner_);
}

template <int D>
void DomainMapping<D>::pose() {
  poses_.clear();
  for (const auto& solid : solids_) poses_.push_back(solid.at(time_));
}

template <int D>
typename DomainMapping<D>::Change DomainMapping<D>::update(double t) {
  change_ = {};
  changed_.clear();
  for (const auto& solid : solids_) {
    const double turned = std::abs(solid.drive.angle(t) - solid.drive.angle(time_));
    travel_ += turned;
  }
  time_ = t;
  pose();
  const bool all = travel_ > rebase_after;
  if (all) travel_ = 0;
  for (std::size_t s = 0; s < solids_.size(); ++s) evaluate(reach_[s].cells, all);
  for (auto& held : held_) held.update();
  change_.any = grid_.parallel().any(change_.any);
  if (change_.any) {
    change_.flipped = heaviside_.kind == Heaviside::Kind::sharp;
    exchange();
    for (int d = 0; d < D; ++d) swept_[d].update(open_[d].data());
  }
  return change_;
}

template <int D>
void DomainMapping<D>::impose(std::array<Field, D>& u) const {
  for (std::size_t s = 0; s < solids_.size(); ++s) {
    if (!solids_[s].drive.moving()) continue;
    for (int d = 0; d < D; ++d)
      for_surface(s, d, [&](const SurfaceFace<D>& face) {
        if (open_[d][face.p] <= 0) u[d][face.p] = poses_[s].velocity(in_space<D>(face.x))[d];
      });
  }
}

template <int D>
void DomainMapping<D>::still(std::array<Field, D>& u) const {
  for (int d = 0; d < D; ++d)
    for (long p = 0; p < grid_.block().size; ++p)
      if (open_[d][p] == 0 && owner_[d][p] < solids_.size()) u[d][p] = 0;
}

template <int D>
void DomainMapping<D>::state(Archive& archive) {
  const GridPart part = grid_.part();
  archive.grids("open", open_, part);
  archive.grids("owner", owner_, part);
  archive.grids("expiry", expiry_, part);
  archive.value("time", time_);
  archive.value("travel", travel_);
  if (!archive.reading()) return;
  pose();
  find_surface();
  hold();
}

/// All faces that are held.
template <int D>
void DomainMapping<D>::hold() {
  if (heaviside_.kind == Heaviside::Kind::sharp) return;
  for (auto& held : held_) held.clear();
  CellBox<D> whole;
  whole.upper = grid_.block().count;
  evaluate(whole, true);
  for (auto& held : held_) held.update();
  changed_.clear();
}

template class DomainMapping<2>;
template class DomainMapping<3>;

}  // namespace washtub
