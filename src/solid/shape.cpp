#include "solid/shape.hpp"

#include <limits>

#include "solid/shape_node.hpp"

namespace washtub {
namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

struct Empty final : Shape::Node {
  double psi(const Vec<3>&) const override { return -infinity; }
  Bounds bounds() const override {
    return {Vec<3>::Constant(infinity), Vec<3>::Constant(-infinity)};
  }
};

}  // namespace

Shape::Shape() : node_(std::make_shared<Empty>()) {}

double Shape::psi(const Vec<3>& x) const { return node_->psi(x); }

Bounds Shape::bounds() const { return node_->bounds(); }

bool Shape::exact_outside() const { return node_->exact_outside(); }

}  // namespace washtub
