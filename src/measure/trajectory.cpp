#include "measure/trajectory.hpp"

#include <numbers>

namespace washtub {
namespace {

double cross(const Vec<2>& a, const Vec<2>& b) { return a[0] * b[1] - a[1] * b[0]; }

}  // namespace

Vec<2> mean_position(std::span<const double> times, std::span<const Vec<2>> track) {
  if (track.size() == 1) return track.front();
  Vec<2> sum = Vec<2>::Zero();
  for (std::size_t i = 1; i < track.size(); ++i)
    sum += 0.5 * (times[i] - times[i - 1]) * (track[i] + track[i - 1]);
  return sum / (times.back() - times.front());
}

Loop loop(std::span<const double> times, std::span<const Vec<2>> track) {
  Loop result{mean_position(times, track)};
  for (std::size_t i = 1; i < track.size(); ++i) {
    const Vec<2> from = track[i - 1] - result.centre, to = track[i] - result.centre;
    result.area += 0.5 * cross(from, to);
    result.turns += std::atan2(cross(from, to), from.dot(to)) / (2 * std::numbers::pi);
  }
  return result;
}

void VelocityMap::add(std::span<const double> times, std::span<const Vec<2>> track) {
  for (std::size_t i = 1; i < track.size(); ++i) {
    const double dt = times[i] - times[i - 1];
    const Vec<2> at = 0.5 * (track[i] + track[i - 1]);
    const Vec<2> velocity = (track[i] - track[i - 1]) / dt;
    if (at[0] > 0.7 * radius_) wall_.add(velocity[1], dt);
    if (at[0] < 0.5 * radius_) axis_.add(velocity[1], dt);
    if (at[1] > 2 * depth_ / 3) top_.add(velocity[0], dt);
    if (at[1] < depth_ / 3) floor_.add(velocity[0], dt);
  }
}

int VelocityMap::agreeing() const {
  return (wall_.mean() > 0) + (axis_.mean() < 0) + (top_.mean() < 0) + (floor_.mean() > 0);
}

}  // namespace washtub
