#include "contact/repulsion.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>

#include "cloth/face_normal.hpp"
#include "contact/geometry.hpp"

namespace washtub {
namespace {

constexpr double sample = 0.9;     // largest distance of samples, of the range
constexpr double own = 1.4;        // of the range: nearer corners of one piece do not repel
constexpr double skin = 0.5;       // of the neighbour lists, of the range
constexpr double steepest = 0.25;  // of areal mass / dt^2: bound of -p'
constexpr double stopped = 0.1;    // part of the areal mass that friction may stop in a step

float rounded_down(double positive) { return static_cast<float>((1 - 1e-6) * positive); }

/// Barycentric weights of the middles of `parts` equal parts of a segment, or of the parts^2 equal
/// parts of a triangle.
template <int D>
std::vector<std::array<double, D>> middles(int parts) {
  std::vector<std::array<double, D>> out;
  for (int j = 0; j < (D == 3 ? parts : 1); ++j)
    for (int i = 0; i + j < parts; ++i) {
      if constexpr (D == 2) {
        const double t = (i + 0.5) / parts;
        out.push_back({1 - t, t});
      } else {
        const auto add = [&](double third) {
          const double u = (i + third) / parts, v = (j + third) / parts;
          out.push_back({1 - u - v, u, v});
        };
        add(1.0 / 3);
        if (i + j + 1 < parts) add(2.0 / 3);  // the part that points the other way
      }
    }
  return out;
}

}  // namespace

template <int D>
Repulsion<D>::Repulsion(const ClothSurface<D>& surface, const Mesh<D>& mesh,
                        const Parallel& parallel, const ContactSettings& settings,
                        std::vector<std::vector<double>> friction)
    : surface_(surface),
      mesh_(mesh),
      parallel_(parallel),
      set_(settings),
      friction_(std::move(friction)),
      skin_(skin * settings.range) {
  if (!(settings.range > 0)) throw std::logic_error("Repulsion: needs a range > 0");
  for (int p = 0; p < surface.pieces(); ++p)
    for (int f = surface.first_face[p]; f < surface.first_face[p + 1]; ++f) {
      piece_.push_back(p);
      const auto rest = surface.rest_of(f, p);
      double edge = 0;
      for (std::size_t k = 0; k < D; ++k)
        edge = std::max(edge, (rest[(k + 1) % D] - rest[k]).norm());
      if (D == 3) edge /= std::sqrt(2.0);
      if (mine(f))
        add_samples(f, std::max(1, static_cast<int>(std::ceil(edge / (sample * set_.range)))));
    }
  centre_.resize(piece_.size());
  normal_.resize(piece_.size(), Vec<D>::Zero());
  radius_.resize(piece_.size());
  turned_.resize(piece_.size());
}

template <int D>
void Repulsion<D>::add_samples(int face, int parts) {
  const auto all = middles<D>(parts);
  for (const Weights& w : all)
    samples_.push_back({face, w, surface_.area[piece_[face]] / static_cast<double>(all.size())});
}

template <int D>
Vec<D> Repulsion<D>::at(const Sample& s, const std::vector<Vec<D>>& x) const {
  Vec<D> sum = Vec<D>::Zero();
  for (std::size_t k = 0; k < D; ++k) sum += s.weight[k] * x[surface_.faces[s.face][k]];
  return sum;
}

/// Whether two faces count as different parts of the cloth.
template <int D>
bool Repulsion<D>::apart(int a, int b) const {
  const int p = piece_[a];
  if (p != piece_[b]) return true;
  for (const int i : surface_.faces[a])
    for (const int j : surface_.faces[b])
      if (surface_.rest_distance(p, surface_.rest[i], surface_.rest[j]) <= own * set_.range)
        return false;
  return true;
}

/// Lists the faces that may come within the range of each other before points move by half a skin.
template <int D>
void Repulsion<D>::list() {
  where_ = x_;
  travelled_ = 0;
  std::fill(turned_.begin(), turned_.end(), 0.0);
  near_.clear();
  first_.assign(1, 0);
  std::vector<BoundingBox<D>> boxes;
  for (const auto& face : surface_.faces) {
    std::array<Vec<D>, D> corners;
    for (std::size_t k = 0; k < D; ++k) corners[k] = x_[face[k]];
    boxes.push_back(box_about<D>(corners));
  }
  const double longest = 2 * *std::max_element(radius_.begin(), radius_.end());
  far_ = set_.range + skin_ + longest;
  const BoxLists<D> faces(boxes, mesh_, longest + 2 * (set_.range + skin_));
  int face = -1;
  for (const Sample& s : samples_) {
    if (s.face != face) list_faces_near(face = s.face, faces);
    list_near(s);
  }
}

template <int D>
void Repulsion<D>::list_faces_near(int face, const BoxLists<D>& faces) {
  about_.clear();
  const Vec<D> far = Vec<D>::Constant(set_.range + skin_ + radius_[face]);
  faces.for_overlaps({centre_[face] - far, centre_[face] + far}, [&](std::size_t f, const Vec<D>&) {
    const int other = static_cast<int>(f);
    const Vec<D> way = centre_[face] - centre_[other];
    if ((way - mesh_.periods_in(way)).norm() < far[0] + radius_[other] && apart(face, other))
      about_.push_back(other);
  });
}

/// Lists those of them that may come within the range.
template <int D>
void Repulsion<D>::list_near(const Sample& s) {
  const Vec<D> x = at(s, x_);
  for (const int face : about_) {
    const double least = bound(x - centre_[face], face);
    if (least < set_.range + skin_) near_.push_back({face, rounded_down(least), 0});
  }
  first_.push_back(near_.size());
}

/// Of the distance of a point and a face, from below.
template <int D>
double Repulsion<D>::bound(const Vec<D>& from_centre, int face) const {
  const Vec<D> way = from_centre - mesh_.periods_in(from_centre);
  const double height = std::abs(normal_[face].dot(way));
  const double squares = way.squaredNorm() - height * height, radius = radius_[face];
  const double aside = squares > radius * radius ? std::sqrt(squares) - radius : 0;
  return aside > 0 ? std::sqrt(height * height + aside * aside) : height;
}

/// Whether a face may be nearer than what has been found on its side of the sample's surface.
template <int D>
bool Repulsion<D>::may_be_nearest(const Near& near, const Sample& s, const Feet& feet) const {
  const double aside = near.aside, bound = near.bound - loss();
  if (std::abs(aside) > loss_aside(s.face)) return bound < feet[side_of(-aside)].distance;
  return bound < farther(feet);
}

/// Takes the nearest point of a face if it is nearer than the one found so far on its side of the
/// sample's surface, and notes how the face lies.
template <int D>
void Repulsion<D>::look(const Sample& s, const Vec<D>& x, Near& near, Feet& feet) const {
  const int face = near.face;
  const Vec<D>& normal = normal_[s.face];
  Vec<D> way = x - centre_[face];
  way -= mesh_.periods_in(way);
  std::array<Vec<D>, D> corners;  // from its centre
  double lowest = std::numeric_limits<double>::infinity(), highest = -lowest;
  for (std::size_t k = 0; k < D; ++k) {
    corners[k] = x_[surface_.faces[face][k]] - centre_[face];
    const double height = normal.dot(way - corners[k]);
    lowest = std::min(lowest, height);
    highest = std::max(highest, height);
  }
  const auto w = nearest_weights(way, corners);
  Vec<D> gap = way;
  for (std::size_t k = 0; k < D; ++k) gap -= w[k] * corners[k];
  const double d = gap.norm(), lost = loss_aside(s.face);
  near.bound = rounded_down(d + loss());
  near.aside = lowest > 0    ? -rounded_down(lowest + lost)
               : highest < 0 ? rounded_down(lost - highest)
                             : 0;
  Foot& foot = feet[side_of(gap.dot(normal))];
  if (d < foot.distance) foot = {face, w, gap, d};
}

/// p(d) with P as it is at this time.
template <int D>
double Repulsion<D>::pressure(double d, double dt) const {
  const double P = set_.pressure * (set_.rise > 0 ? std::min(1.0, age_ / set_.rise) : 1);
  if (!(P > 0)) return 0;
  const double d0 = set_.range, yields = dt * dt / set_.areal_mass + dt * set_.permeability;
  const double bound = steepest / yields;
  const double knee = d0 / std::sqrt(bound * d0 / P + 1);  // -p' = P (d0/d^2 - 1/d0) = bound
  const auto law = [&](double x) { return P * (1 - x / d0) * (1 - x / d0) * d0 / x; };
  return d > knee ? law(d) : law(knee) + bound * (knee - d);
}

template <int D>
Vec<D> Repulsion<D>::drag(const Sample& s, const Foot& foot, double normal, double dt) const {
  const auto group = [&](int face) {
    return static_cast<std::size_t>(surface_.group[piece_[face]]);
  };
  const double friction = friction_[group(s.face)][group(foot.face)];
  if (!(friction > 0)) return Vec<D>::Zero();
  Vec<D> v = at(s, v_);
  for (std::size_t k = 0; k < D; ++k) v -= foot.weight[k] * v_[surface_.faces[foot.face][k]];
  const Vec<D> n = foot.gap / foot.distance, slide = v - v.dot(n) * n;
  const double speed = slide.norm();
  if (!(speed > 0)) return Vec<D>::Zero();
  const double stop = stopped * s.area * set_.areal_mass * speed / dt;
  return -std::min(friction * normal, stop) / speed * slide;
}

/// Pushes a sample and the nearest point of another part off each other.
template <int D>
void Repulsion<D>::push(const Sample& s, const Foot& foot, double dt) {
  if (!(foot.distance > 0)) return;
  const double normal = 0.5 * s.area * pressure(foot.distance, dt);  // half from either side
  const Vec<D> f = normal / foot.distance * foot.gap + drag(s, foot, normal, dt);
  for (std::size_t k = 0; k < D; ++k) {
    sum_[surface_.node[surface_.faces[s.face][k]]] += s.weight[k] * f;
    sum_[surface_.node[surface_.faces[foot.face][k]]] -= foot.weight[k] * f;
  }
}

template <int D>
void Repulsion<D>::measure_faces() {
  for (std::size_t f = 0; f < centre_.size(); ++f) {
    const auto& face = surface_.faces[f];
    const Vec<D> normal = face_normal<D>(face, x_).normalized();
    turned_[f] += (normal - normal_[f]).norm();
    normal_[f] = normal;
    centre_[f].setZero();
    for (const int point : face) centre_[f] += x_[point] / D;
    double squares = 0;
    for (const int point : face)
      squares = std::max(squares, (x_[point] - centre_[f]).squaredNorm());
    radius_[f] = std::sqrt(squares);
  }
}

/// Pushes a sample off what is nearest to it on either side. What was nearest comes first the next
/// time.
template <int D>
void Repulsion<D>::push_off(std::size_t sample, double dt) {
  const Sample& s = samples_[sample];
  Feet feet{no_foot(set_.range), no_foot(set_.range)};
  const Vec<D> x = at(s, x_);
  const std::size_t first = first_[sample];
  std::array<std::size_t, 2> place{first, first};  // of the nearest in the list
  for (std::size_t k = first; k < first_[sample + 1]; ++k) {
    Near& near = near_[k];
    if (!may_be_nearest(near, s, feet)) continue;
    look(s, x, near, feet);
    for (std::size_t side = 0; side < 2; ++side)
      if (feet[side].face == near.face) place[side] = k;
  }
  std::swap(near_[first], near_[place[0]]);
  if (place[1] == first) place[1] = place[0];  // where it has gone
  if (feet[1].face >= 0 && feet[0].face >= 0) std::swap(near_[first + 1], near_[place[1]]);
  for (const Foot& foot : feet)
    if (foot.face >= 0) push(s, foot, dt);
}

/// Whether what is listed may not be all that matters now.
template <int D>
bool Repulsion<D>::is_outdated() const {
  return where_.size() != x_.size() || 2 * farthest<D>(where_, x_) > skin_;
}

template <int D>
void Repulsion<D>::add(const ClothMoment<D>& now, std::vector<Vec<D>>& force) {
  age_ += now.dt;
  if (!surface_.place(now.position, x_)) return;
  v_.resize(x_.size());
  for (std::size_t i = 0; i < v_.size(); ++i) v_[i] = now.velocity[surface_.node[i]];
  measure_faces();
  if (before_.size() == x_.size()) travelled_ += farthest<D>(before_, x_);
  before_ = x_;
  if (is_outdated()) list();
  sum_.assign(force.size(), Vec<D>::Zero());
  for (std::size_t i = 0; i < samples_.size(); ++i)
    if (first_[i + 1] > first_[i]) push_off(i, now.dt);
  parallel_.sum(std::span<double>(sum_.front().data(), sum_.size() * D));
  for (std::size_t i = 0; i < force.size(); ++i) force[i] += sum_[i];
}

template class Repulsion<2>;
template class Repulsion<3>;

}  // namespace washtub