#include "flow/flow.hpp"

#include <algorithm>
#include <stdexcept>
#include <string>

namespace washtub {
namespace {

void require(bool holds, const char* what) {
  if (!holds) throw std::logic_error(std::string("Flow::") + what);
}

}  // namespace

template <int D>
Flow<D>::Flow(const Grid<D>& grid, double density, double viscosity, const SidePairs<D>& sides,
              const Openings<D>& openings)
    : water_(grid, density, viscosity, sides, openings),
      projection_(water_),
      prediction_(water_, projection_.multigrid()) {}

template <int D>
void Flow<D>::set_velocity(const std::function<Vec<D>(const Vec<D>&)>& field) {
  require(step_ == 0, "set_velocity(): only before the first step");
  water_.set_velocity(field);
}

template <int D>
void Flow<D>::openings_changed(int k0, int k1, bool flipped) {
  require(!predicted(), "openings_changed(): only before predict(dt)");
  projection_.openings_changed(k0, k1, flipped);
  prediction_.openings_changed(k0, k1);
}

template <int D>
void Flow<D>::predict(double dt) {
  require(!predicted(), "predict(dt): the last prediction waits for project()");
  step_before_ = step_;
  step_ = dt;
  water_.passing.advance(water_.velocities(), water_.openings.open, dt, water_.speed);
  water_.exchange();  // solids may have moved since, and with them the faces they close
  prediction_.advance(dt, step_before_, projection_.warm_start().gradient_holds());
  stage_ = Stage::predicted;
  has_kept_ = false;
}

template <int D>
ProvisionalVelocity<D> Flow<D>::provisional() const {
  require(predicted(), "provisional(): only after predict(dt)");
  return {water_, pressure(), step_};
}

template <int D>
void Flow<D>::keep_prediction() {
  require(stage_ == Stage::predicted, "keep_prediction(): only between predict(dt) and project()");
  for (int d = 0; d < D; ++d) {
    if (kept_[d].size() == 0) kept_[d] = grid().make_field();
    std::copy_n(water_.u[d].data(), water_.u[d].size(), kept_[d].data());
  }
  has_kept_ = true;
}

template <int D>
void Flow<D>::return_to_prediction() {
  require(has_kept_, "return_to_prediction(): no keep_prediction() in this step");
  for (int d = 0; d < D; ++d) std::copy_n(kept_[d].data(), kept_[d].size(), water_.u[d].data());
  if (!predicted()) stage_ = Stage::returned;
}

template <int D>
typename Flow<D>::Report Flow<D>::project(double tolerance, int max_cycles) {
  require(predicted(), "project(): only after predict(dt)");
  const bool again = stage_ == Stage::returned;
  stage_ = Stage::projected;
  return projection_.project(step_, {tolerance, max_cycles}, again);
}

template <int D>
void Flow<D>::restart() {
  for (auto& f : water_.f) f.fill(0);
  projection_.restart();
  prediction_.restart();
  step_ = 0;
}

template <int D>
void Flow<D>::state(Archive& archive) {
  archive.value("water", water_);
  archive.value("projection", projection_);
  archive.value("prediction", prediction_);
  archive.value("step", step_);
  if (!archive.reading()) return;
  stage_ = Stage::projected;  // a step that failed is forgotten
  has_kept_ = false;
}

template class Flow<2>;
template class Flow<3>;

}  // namespace washtub
