#pragma once
#include "cloth/cloth.hpp"
#include "cloth/nodal_force.hpp"

namespace washtub {

/// Gravity [m/s^2] on the mass of the cloth beyond that of the displaced water.
template <int D>
class Weight : public NodalForce<D> {
 public:
  Weight(const Cloth<D>& cloth, const Vec<D>& gravity) {
    for (const double mass : excess_masses(cloth)) weight_.push_back(mass * gravity);
  }
  void add(const ClothMoment<D>&, std::vector<Vec<D>>& force) override {
    for (std::size_t i = 0; i < weight_.size(); ++i) force[i] += weight_[i];
  }

 private:
  std::vector<Vec<D>> weight_;
};

}  // namespace washtub
