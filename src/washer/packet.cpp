#include "washer/packet.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <random>

#include "base/error.hpp"

namespace washtub {
namespace {

constexpr double pi = std::numbers::pi;

/// Where nodes along one direction of a sheet are folded to and fro.
struct Folds {
  int nodes, layers;

  int tip(int k) const {  ///< the node at which layer k begins
    return k * ((nodes - 1) / layers) + std::min(k, (nodes - 1) % layers);
  }
  bool is_tip(int i) const {
    for (int k = 1; k < layers; ++k)
      if (tip(k) == i) return true;
    return false;
  }
  /// Of the edge from node i to i + 1; a tip begins one.
  int layer(int i) const {
    int k = 0;
    while (k + 1 < layers && tip(k + 1) <= i) ++k;
    return k;
  }
};

/// Places along a folded direction, all `step` from each other, at the heights given.
std::vector<double> zigzag(const Folds& folds, double step, const std::vector<double>& height) {
  std::vector<double> x = {0};
  for (int i = 0; i + 1 < folds.nodes; ++i) {
    const double rise =
        height[static_cast<std::size_t>(i) + 1] - height[static_cast<std::size_t>(i)];
    const double way = std::sqrt(std::max(0.0, step * step - rise * rise));
    x.push_back(x.back() + (folds.layer(i) % 2 == 0 ? way : -way));
  }
  return x;
}

/// Heights of the nodes of one layer `z` (of a packet `thick`) that is folded as a whole.
std::vector<double> heights(const Folds& folds, double z, double thick, double apart) {
  std::vector<double> height;
  for (int i = 0; i < folds.nodes; ++i) {
    const int k = folds.layer(i);
    const double base = k * (thick + apart);
    height.push_back(folds.is_tip(i) ? base - 0.5 * apart
                     : k % 2 == 0    ? base + z
                                     : base + thick - z);
  }
  return height;
}

void centre(Packet& packet) {
  Vec<3> least = packet.nodes.front(), most = least;
  for (const Vec<3>& x : packet.nodes) {
    least = least.cwiseMin(x);
    most = most.cwiseMax(x);
  }
  for (Vec<3>& x : packet.nodes) x -= 0.5 * (least + most);
  packet.size = {most[0] - least[0], most[1] - least[1]};
  packet.thickness = most[2] - least[2];
}

void refuse_folds(const Folds& folds, double step, double height) {
  if (folds.layers == 1) return;
  if ((folds.nodes - 1) / folds.layers < 2 || height > step)
    throw InputError(fmt::format(
        "cloth.folded: {} layers are too many for {} nodes {:.3g} m apart; try fewer of them, a "
        "smaller cloth.spacing, more domain.cells, or a smaller contact.gap",
        folds.layers, folds.nodes, step));
}

Packet fold(const ClothCase& cloth, const Case& whole) {
  const auto nodes = cloth_nodes(cloth, whole);
  const auto step = cloth_spacing(cloth, whole);
  const Folds r{nodes[0], cloth.folded[0]}, s{nodes[1], whole.dimension == 3 ? cloth.folded[1] : 1};
  const double gap = complete_contact(whole).gap, longest = std::max(step[0], step[1]);
  // The inner tip of a double fold keeps about 1.5 apart^2/step from the outer one.
  const bool twice = r.layers > 1 && s.layers > 1;
  const double apart = std::max(1.3 * gap, twice ? std::sqrt(gap * longest) : 0);
  const double thick = (r.layers - 1) * apart;
  refuse_folds(r, step[0], 0.5 * apart);
  if (whole.dimension == 3) refuse_folds(s, step[1], thick + 0.5 * apart);
  const auto z = heights(r, 0, 0, apart);
  const auto x = zigzag(r, step[0], z);
  Packet packet;
  packet.nodes.resize(x.size() * static_cast<std::size_t>(s.nodes));
  for (std::size_t i = 0; i < x.size(); ++i) {
    const auto height = heights(s, z[i], thick, apart);
    const auto y = zigzag(s, step[1], height);
    const double half = thick + 0.5 * apart - z[i];  // of the way round the first tip
    const double out =
        s.layers > 1 ? half - std::sqrt(std::max(0.0, step[1] * step[1] - half * half)) : 0;
    for (std::size_t j = 0; j < y.size(); ++j)
      packet.nodes[i + x.size() * j] = {x[i], y[j] + out, height[j]};
  }
  centre(packet);
  return packet;
}

/// The direction of a curve at random, by the length along it.
class Creases {
 public:
  Creases(double length, int waves, std::uint64_t seed) : length_(length) {
    std::mt19937_64 random(seed);
    const auto uniform = [&] { return static_cast<double>(random() >> 11) * 0x1p-53; };
    for (int k = 0; k < waves; ++k) waves_.push_back({0.5 + uniform(), 2 * pi * uniform()});
  }
  double angle(double at, double strength) const {
    double sum = 0, squares = 0;
    for (std::size_t k = 0; k < waves_.size(); ++k) {
      sum += waves_[k][0] *
             std::sin(2 * pi * static_cast<double>(k + 1) * at / length_ + waves_[k][1]);
      squares += 0.5 * waves_[k][0] * waves_[k][0];
    }
    return steepest * std::tanh(strength * sum / (steepest * std::sqrt(squares)));
  }
  /// Points of the curve, `count` intervals along it.
  std::vector<Vec<2>> curve(double strength, int count) const {
    std::vector<Vec<2>> points = {Vec<2>::Zero()};
    const double step = length_ / count;
    for (int i = 0; i < count; ++i) {
      const double a = angle((i + 0.5) * step, strength);
      points.push_back(points.back() + step * Vec<2>(std::cos(a), std::sin(a)));
    }
    return points;
  }

 private:
  static constexpr double steepest = 1.45;  // [rad], so that the curve does not come back
  double length_;
  std::vector<std::array<double, 2>> waves_;  ///< amplitude and phase
};

constexpr int fine = 2000;        // intervals of the curve of a crumpled piece
constexpr double sharpest = 0.9;  // most that its direction turns from node to node [rad]

Packet crumple(const ClothCase& cloth, const Case& whole, std::uint64_t draw) {
  const auto nodes = cloth_nodes(cloth, whole);
  const auto step = cloth_spacing(cloth, whole);
  std::mt19937_64 random(cloth.seed + 1000 * (draw + 1));
  const double turn =
      whole.dimension == 3 ? 2 * pi * static_cast<double>(random() >> 11) * 0x1p-53 : 0;
  const double c = std::cos(turn), s = std::sin(turn);
  const double wide = (nodes[0] - 1) * step[0], high = (nodes[1] - 1) * step[1];
  const double length = std::abs(c) * wide + std::abs(s) * high;
  const double longest = std::max(step[0], step[1]);
  const int waves = std::max(1, static_cast<int>(length / (12 * longest)));
  const Creases creases(length, waves, random());
  double strength = 0, stronger = 10;
  for (int k = 0; k < 50; ++k) {
    const double middle = 0.5 * (strength + stronger);
    const bool enough = creases.curve(middle, fine).back().norm() < (1 - cloth.crumpled) * length;
    (enough ? stronger : strength) = middle;
  }
  double sharp = 0;
  for (double at = 0; at + longest < length; at += 0.1 * longest)
    sharp = std::max(sharp,
                     std::abs(creases.angle(at + longest, strength) - creases.angle(at, strength)));
  if (sharp > 2 * sharpest)
    throw InputError(fmt::format(
        "cloth.crumpled = {}: {} nodes {:.3g} m apart cannot be bent as sharply as that; try a "
        "smaller cloth.crumpled, a smaller cloth.spacing or more domain.cells",
        cloth.crumpled, std::max(nodes[0], nodes[1]), longest));
  const auto curve = creases.curve(strength, fine);
  const Vec<2> along = (curve.back() - curve.front()).normalized();
  Packet packet;
  for (int j = 0; j < nodes[1]; ++j)
    for (int i = 0; i < nodes[0]; ++i) {
      const double x = i * step[0] - 0.5 * wide, y = j * step[1] - 0.5 * high;
      const double u = c * x + s * y, v = c * y - s * x;
      const double at = std::clamp((u + 0.5 * length) / length, 0.0, 1.0) * fine;
      const int k = std::min(static_cast<int>(at), fine - 1);
      const Vec<2> p =
          curve[static_cast<std::size_t>(k)] +
          (at - k) * (curve[static_cast<std::size_t>(k) + 1] - curve[static_cast<std::size_t>(k)]);
      const double across = along.dot(p), up = along[0] * p[1] - along[1] * p[0];
      packet.nodes.emplace_back(c * across - s * v, s * across + c * v, up);
    }
  centre(packet);
  return packet;
}

}  // namespace

bool is_packed(const ClothCase& cloth) {
  return cloth.crumpled > 0 || cloth.folded != std::array{1, 1};
}

Packet make_packet(const ClothCase& cloth, const Case& whole, std::uint64_t draw) {
  return cloth.crumpled > 0 ? crumple(cloth, whole, draw) : fold(cloth, whole);
}

}  // namespace washtub
