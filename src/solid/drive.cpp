#include "solid/drive.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "base/error.hpp"

namespace washtub {

struct Drive::Law {
  virtual ~Law() = default;
  virtual double speed(double t) const = 0;
  virtual double angle(double t) const = 0;
  virtual double peak() const = 0;
  virtual double period() const = 0;
};

namespace {

struct Constant final : Drive::Law {
  explicit Constant(double w) : omega(w) {}
  double speed(double) const override { return omega; }
  double angle(double t) const override { return omega * t; }
  double peak() const override { return std::abs(omega); }
  double period() const override { return 0; }
  double omega;
};

struct Sinusoid final : Drive::Law {
  Sinusoid(double w, double f) : amplitude(w), rate(2 * std::numbers::pi * f) {}
  double speed(double t) const override { return amplitude * std::sin(rate * t); }
  double angle(double t) const override { return amplitude / rate * (1 - std::cos(rate * t)); }
  double peak() const override { return std::abs(amplitude); }
  double period() const override { return 2 * std::numbers::pi / rate; }
  double amplitude, rate;
};

struct Table final : Drive::Law {
  Table(const std::vector<double>& times, const std::vector<double>& speeds, bool again)
      : t(times), w(speeds), swept(times.size(), 0.0), repeat(again) {
    for (std::size_t i = 1; i < t.size(); ++i)
      swept[i] = swept[i - 1] + 0.5 * (w[i] + w[i - 1]) * (t[i] - t[i - 1]);
  }

  double speed(double time) const override {
    if (!repeat && time >= t.back()) return w.back();
    const auto [cycle, rest] = split(time);
    const std::size_t i = interval(rest);
    return w[i] + slope(i) * (rest - t[i]);
  }

  double angle(double time) const override {
    if (!repeat && time >= t.back()) return swept.back() + w.back() * (time - t.back());
    const auto [cycle, rest] = split(time);
    const std::size_t i = interval(rest);
    const double s = rest - t[i];
    return cycle * swept.back() + swept[i] + s * (w[i] + 0.5 * slope(i) * s);
  }

  double peak() const override {
    double largest = 0;
    for (const double speed : w) largest = std::max(largest, std::abs(speed));
    return largest;
  }

  double period() const override { return repeat ? t.back() : 0; }

 private:
  struct Phase {
    double cycle, rest;  ///< whole cycles done, time since [s]
  };
  Phase split(double time) const {
    if (!repeat) return {0, time};
    const double cycle = std::floor(time / t.back());
    return {cycle, time - cycle * t.back()};
  }
  std::size_t interval(double rest) const {
    const auto after = std::upper_bound(t.begin() + 1, t.end() - 1, rest);
    return static_cast<std::size_t>(after - t.begin()) - 1;
  }
  double slope(std::size_t i) const { return (w[i + 1] - w[i]) / (t[i + 1] - t[i]); }

  std::vector<double> t, w, swept;
  bool repeat;
};

void require_finite(const char* drive, const char* name, double value) {
  if (!std::isfinite(value))
    throw InputError(fmt::format("{}: {} = {}: expected a finite number", drive, name, value));
}

void require_table(const std::vector<double>& times, const std::vector<double>& speeds) {
  if (times.size() != speeds.size())
    throw InputError(fmt::format("stroke_table: {} times but {} speeds: expected as many of both",
                                 times.size(), speeds.size()));
  if (times.size() < 2)
    throw InputError(fmt::format("stroke_table: {} points: expected at least two", times.size()));
  for (const double speed : speeds) require_finite("stroke_table", "speeds", speed);
  for (const double time : times) require_finite("stroke_table", "times", time);
  if (times.front() != 0)
    throw InputError(fmt::format("stroke_table: times start at {} s: expected 0", times.front()));
  for (std::size_t i = 1; i < times.size(); ++i)
    if (!(times[i] > times[i - 1]))
      throw InputError(fmt::format("stroke_table: times[{}] = {} s after {} s: expected increasing",
                                   i, times[i], times[i - 1]));
}

}  // namespace

double Drive::speed(double t) const { return law_->speed(t); }
double Drive::angle(double t) const { return law_->angle(t); }
double Drive::peak() const { return law_->peak(); }
double Drive::period() const { return law_->period(); }

Drive at_rest() { return constant_speed(0); }

Drive constant_speed(double omega) {
  require_finite("constant_speed", "omega", omega);
  return Drive(std::make_shared<Constant>(omega));
}

Drive sinusoid(double peak, double frequency) {
  require_finite("sinusoid", "peak", peak);
  if (!(frequency > 0) || !std::isfinite(frequency))
    throw InputError(
        fmt::format("sinusoid: frequency = {} Hz: expected a positive number", frequency));
  return Drive(std::make_shared<Sinusoid>(peak, frequency));
}

Drive stroke_table(const std::vector<double>& times, const std::vector<double>& speeds,
                   bool repeat) {
  require_table(times, speeds);
  return Drive(std::make_shared<Table>(times, speeds, repeat));
}

}  // namespace washtub
