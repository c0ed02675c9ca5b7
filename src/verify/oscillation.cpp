#include "verify/oscillation.hpp"

#include <Eigen/Dense>
#include <cmath>
#include <limits>
#include <numbers>
#include <vector>

#include "base/error.hpp"

namespace washtub {
namespace {

using Column = Eigen::VectorXd;
/// offset, cosine, sine, decay, angular frequency.
using Parameters = Eigen::Matrix<double, 5, 1>;

/// Times at which the curve changes its sign. It counts only once it has gone beyond `band` on the
/// other side, so that noise around zero does not.
std::vector<double> crossings(const Column& t, const Column& y, double band) {
  std::vector<double> times;
  int side = 0;
  double last = t[0];
  for (Eigen::Index i = 0; i < y.size(); ++i) {
    if (i > 0 && y[i - 1] * y[i] <= 0 && y[i] != y[i - 1])
      last = t[i - 1] + (t[i] - t[i - 1]) * y[i - 1] / (y[i - 1] - y[i]);
    if (std::abs(y[i]) <= band) continue;
    const int now = y[i] > 0 ? 1 : -1;
    if (side != 0 && now != side) times.push_back(last);
    side = now;
  }
  return times;
}

double first_guess(const Column& t, const Column& y) {
  const Column centred = y.array() - y.mean();
  const double rms = std::sqrt(centred.squaredNorm() / static_cast<double>(y.size()));
  const auto times = crossings(t, centred, 0.1 * rms);
  if (times.size() < 3 || y.size() < 8)
    throw InputError(
        "fewer than one and a half oscillations in the window; widen `window`, or lower "
        "output.every of the case");
  return std::numbers::pi * static_cast<double>(times.size() - 1) / (times.back() - times.front());
}

/// Columns 1, exp(-at) cos wt, exp(-at) sin wt.
Eigen::MatrixX3d basis(const Column& t, double a, double w) {
  Eigen::MatrixX3d columns(t.size(), 3);
  const Eigen::ArrayXd envelope = (-a * t.array()).exp();
  columns.col(0).setOnes();
  columns.col(1) = envelope * (w * t.array()).cos();
  columns.col(2) = envelope * (w * t.array()).sin();
  return columns;
}

/// Linear coefficients for a decay and an angular frequency, by the normal equations.
Eigen::Vector3d linear_fit(const Eigen::MatrixX3d& columns, const Column& y) {
  return (columns.transpose() * columns).ldlt().solve(columns.transpose() * y);
}

/// The best of a lattice of frequencies around `guess` and of decays.
Parameters search(const Column& t, const Column& y, double guess) {
  const double length = t[t.size() - 1] - t[0];
  const double step = std::numbers::pi / (4 * length);
  Parameters best;
  double least = std::numeric_limits<double>::infinity();
  const double reach = std::min(0.5 * guess, 64 * step);
  for (double w = guess - reach; w <= guess + reach; w += step)
    for (const double a : {0.0, 1.0, 3.0, 8.0, -2.0}) {
      const auto columns = basis(t, a / length, w);
      const Eigen::Vector3d c = linear_fit(columns, y);
      const double misfit = (columns * c - y).squaredNorm();
      if (!(misfit < least)) continue;
      least = misfit;
      best << c, a / length, w;
    }
  return best;
}

Column misfit(const Column& t, const Column& y, const Parameters& p) {
  return basis(t, p[3], p[4]) * p.head<3>() - y;
}

Eigen::MatrixXd jacobian(const Column& t, const Parameters& p) {
  Eigen::MatrixXd j(t.size(), 5);
  const auto columns = basis(t, p[3], p[4]);
  j.leftCols<3>() = columns;
  j.col(3) = -t.array() * (p[1] * columns.col(1) + p[2] * columns.col(2)).array();
  j.col(4) = t.array() * (p[2] * columns.col(1) - p[1] * columns.col(2)).array();
  return j;
}

Parameters refine(const Column& t, const Column& y, Parameters p) {
  double damping = 1e-3;
  Column r = misfit(t, y, p);
  for (int iteration = 0; iteration < 60 && damping < 1e12; ++iteration) {
    const auto j = jacobian(t, p);
    Eigen::MatrixXd normal = j.transpose() * j;
    normal.diagonal() *= 1 + damping;
    const Parameters step = normal.ldlt().solve(-j.transpose() * r);
    const Column trial = misfit(t, y, p + step);
    if (!(trial.squaredNorm() <= r.squaredNorm())) {
      damping *= 8;
      continue;
    }
    p += step;
    r = trial;
    damping /= 8;
    if (std::abs(step[4]) < 1e-12 * p[4] && std::abs(step[3]) < 1e-12 * p[4]) break;
  }
  return p;
}

}  // namespace

Oscillation fit_oscillation(std::span<const double> times, std::span<const double> values) {
  const auto n = static_cast<Eigen::Index>(values.size());
  if (n < 8) throw InputError("fewer than eight samples in the window; widen `window`");
  const Column y = Eigen::Map<const Column>(values.data(), n);
  const Column t = Eigen::Map<const Column>(times.data(), n).array() - times.front();
  const Parameters p = refine(t, y, search(t, y, first_guess(t, y)));
  return {p[4] / (2 * std::numbers::pi), p[3], p[0], p[1], p[2]};
}

}  // namespace washtub
