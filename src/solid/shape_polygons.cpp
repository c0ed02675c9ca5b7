#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "base/error.hpp"
#include "solid/shape_node.hpp"

namespace washtub {
namespace {

/// A closed polygon that does not cross itself, in a plane with coordinates (u, v) [m].
class Polygon {
 public:
  /// `axis_is_surface` = false leaves edges on u = 0 out of the distance (solids of revolution).
  Polygon(const std::vector<Vec<2>>& vertices, bool axis_is_surface) {
    lower_ = upper_ = vertices.front();
    for (std::size_t i = 0; i < vertices.size(); ++i) {
      const Vec<2>& a = vertices[i];
      const Vec<2> along = vertices[(i + 1) % vertices.size()] - a;
      const bool surface = axis_is_surface || a[0] > 0 || along[0] > 0;
      edges_.push_back({a, along, 1 / std::max(along.squaredNorm(), 1e-300), surface});
      lower_ = lower_.cwiseMin(a);
      upper_ = upper_.cwiseMax(a);
    }
  }

  /// Signed distance from (u, v) to the outline, positive inside [m].
  double psi(double u, double v) const {
    double nearest = std::numeric_limits<double>::infinity();
    bool inside = false;
    for (const Edge& e : edges_) {
      const double du = u - e.a[0], dv = v - e.a[1];
      if (e.surface) nearest = std::min(nearest, e.squared_distance(du, dv));
      inside ^= e.crossed(du, dv);
    }
    return inside ? std::sqrt(nearest) : -std::sqrt(nearest);
  }

  const Vec<2>& lower() const { return lower_; }
  const Vec<2>& upper() const { return upper_; }

 private:
  struct Edge {
    Vec<2> a, along;
    double inverse;  ///< 1 / |along|^2
    bool surface;

    /// From the point a + (du, dv) to this edge.
    double squared_distance(double du, double dv) const {
      const double s = std::clamp((du * along[0] + dv * along[1]) * inverse, 0.0, 1.0);
      const double pu = du - s * along[0], pv = dv - s * along[1];
      return pu * pu + pv * pv;
    }

    /// Whether the ray from a + (du, dv) towards +u crosses this edge.
    bool crossed(double du, double dv) const {
      if ((dv < 0) == (dv < along[1])) return false;
      const double turn = du * along[1] - dv * along[0];
      return along[1] > 0 ? turn < 0 : turn > 0;
    }
  };
  std::vector<Edge> edges_;
  Vec<2> lower_, upper_;
};

struct Revolution final : Shape::Node {
  explicit Revolution(const std::vector<Vec<2>>& vertices) : profile(vertices, false) {}
  double psi(const Vec<3>& x) const override {
    return profile.psi(std::sqrt(x[0] * x[0] + x[1] * x[1]), x[2]);
  }
  Bounds bounds() const override {
    const double r = profile.upper()[0];
    return {{-r, -r, profile.lower()[1]}, {r, r, profile.upper()[1]}};
  }
  Polygon profile;
};

struct Plate final : Shape::Node {
  Plate(const std::vector<Vec<2>>& vertices, double half) : outline(vertices, true), half(half) {}
  double psi(const Vec<3>& x) const override {
    const double across = std::abs(x[1]) - half;
    const double within = -outline.psi(x[0], x[2]);
    if (within <= 0 || across <= 0) return -std::max(within, across);
    return -std::sqrt(within * within + across * across);
  }
  Bounds bounds() const override {
    const Vec<2>&l = outline.lower(), &u = outline.upper();
    return {{l[0], -half, l[1]}, {u[0], half, u[1]}};
  }
  Polygon outline;
  double half;
};

void require_polygon(const char* shape, const std::vector<Vec<2>>& vertices) {
  if (vertices.size() < 3)
    throw InputError(
        fmt::format("{}: {} vertices: expected at least three", shape, vertices.size()));
  double area = 0;
  for (std::size_t i = 0; i < vertices.size(); ++i) {
    const Vec<2>&a = vertices[i], &b = vertices[(i + 1) % vertices.size()];
    if (!a.allFinite()) throw InputError(fmt::format("{}: vertex {} is not finite", shape, i + 1));
    area += 0.5 * (a[0] * b[1] - a[1] * b[0]);
  }
  if (area == 0) throw InputError(fmt::format("{}: the polygon encloses no area", shape));
}

}  // namespace

Shape revolution(const std::vector<Vec<2>>& profile) {
  require_polygon("revolution", profile);
  for (std::size_t i = 0; i < profile.size(); ++i)
    if (profile[i][0] < 0)
      throw InputError(
          fmt::format("revolution: vertex {} has r = {} m: expected r >= 0", i + 1, profile[i][0]));
  return Shape(std::make_shared<Revolution>(profile));
}

Shape plate(const std::vector<Vec<2>>& outline, double half_thickness) {
  require_polygon("plate", outline);
  if (!(half_thickness > 0) || !std::isfinite(half_thickness))
    throw InputError(fmt::format("plate: half_thickness = {} m: expected a positive, finite length",
                                 half_thickness));
  return Shape(std::make_shared<Plate>(outline, half_thickness));
}

}  // namespace washtub
