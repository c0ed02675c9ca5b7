#include <gtest/gtest.h>

#include <cmath>

#include "solid/loads.hpp"
#include "support/wash_tub.hpp"

namespace washtub {
namespace {

constexpr double inf = std::numeric_limits<double>::infinity();

/// A disc that turns inside a ring, in a square box; r_o = 1.
struct Annulus {
  Grid<2> grid;
  DomainMapping<2> mapping;
  Flow<2> flow;
  double t = 0;

  static Mesh<2> mesh(double width, int n) {
    Mesh<2> m;
    m.lower = Vec<2>::Constant(-width / 2);
    m.h = Vec<2>::Constant(width / n);
    m.cells = {n, n};
    return m;
  }
  static std::vector<Solid> solids(double radius, const Drive& inner, const Drive& outer) {
    return {{"ring", complement(cylinder(1, -inf, inf)), Vec<3>::Zero(), outer},
            {"disc", cylinder(radius, -inf, inf), Vec<3>::Zero(), inner}};
  }
  Annulus(double width, int n, double radius, const Drive& inner, const Drive& outer,
          double viscosity, double gamma_cells)
      : grid(mesh(width, n), Parallel(), granularity(mesh(width, n))),
        mapping(grid, solids(radius, inner, outer), gamma_cells * width / n),
        flow(grid, 1.0, viscosity, {}, testing::openings(mapping)) {}

  void impose() {
    mapping.impose(flow.velocity());
    if (mapping.smooth()) mapping.impose_target(flow.target());
  }
  Flow<2>::Report step(double dt) {
    t += dt;
    const auto change = mapping.update(t);
    if (change.any) flow.openings_changed(0, grid.block().planes(), change.flipped);
    impose();
    flow.predict(dt);
    return flow.project(dt, 1e-6, 60);
  }
  /// Torque of the water on a solid, all parts.
  SurfaceLoads<2> loads(std::size_t solid) const {
    return surface_loads<2>(grid, mapping, solid,
                            {flow.velocity()[0].data(), flow.velocity()[1].data()},
                            flow.pressure().data(), flow.density(), flow.viscosity());
  }
  double torque(std::size_t solid) const {
    return grid.parallel().sum(loads(solid).total().torque);
  }
};

/// Steady circular Couette flow, Eq. (A.12), r_o = Omega_o = 1.
struct Couette {
  static constexpr double r_i = 0.34, omega_i = 6.13, width = 2.82;
  static constexpr double viscosity = (1 - r_i) / 131;
  static double speed(double r) { return 0.32946 * r + 0.67054 / r; }
  static constexpr double torque = 0.04245;
};

struct Errors {
  double largest = 0, rms = 0, torque = 0;
};

/// Errors of Eq. (A.13) over the fluid faces, after the flow has settled from the exact solution.
Errors couette_errors(int n, double gamma_cells, double time) {
  Annulus a(Couette::width, n, Couette::r_i, constant_speed(Couette::omega_i), constant_speed(1),
            Couette::viscosity, gamma_cells);
  const auto& block = a.grid.block();
  const auto for_faces = [&](auto&& visit) {
    for (int d = 0; d < 2; ++d)
      for (int k = 0; k < block.planes(); ++k)
        for (int i = 0; i < block.width(); ++i) {
          const Vec<2> x = a.grid.position({i, k}, d);
          const double r = x.norm();
          if (r <= Couette::r_i || r >= 1) continue;
          const double exact = Couette::speed(r) / r * (d == 0 ? -x[1] : x[0]);
          visit(d, block.at({i, k}), exact, Couette::speed(r));
        }
  };
  for_faces([&](int d, long p, double exact, double) { a.flow.velocity()[d][p] = exact; });
  a.impose();
  a.flow.refresh_ghosts();
  const double dt = 0.25 * (Couette::width / n) / (Couette::omega_i * Couette::r_i);
  while (a.t < time) EXPECT_TRUE(a.step(dt).pressure.converged);

  Errors e;
  double squares = 0, faces = 0;
  for_faces([&](int d, long p, double exact, double speed) {
    const double error = std::abs(a.flow.velocity()[d][p] - exact) / speed;
    e.largest = std::max(e.largest, error);
    squares += error * error;
    faces += 1;
  });
  e.largest = a.grid.parallel().max(e.largest);
  e.rms = std::sqrt(a.grid.parallel().sum(squares) / a.grid.parallel().sum(faces));
  e.torque = a.torque(0);
  std::printf("n %d gamma %g: max %.4f rms %.5f torque ring %.5f (fr %.5f) disc %.5f\n", n,
              gamma_cells, e.largest, e.rms, a.torque(0), a.loads(0).friction.torque, a.torque(1));
  return e;
}

TEST(Couette, Sharp) {
  couette_errors(128, 0, 10);
  couette_errors(128, 2, 10);
}

/// The drive of the tub on a smooth cylinder of radius a; exact torques of reference.md, section 5.
TEST(Couette, OscillatingTorque) {
  const double peak = 1, f = 2 / std::numbers::pi / testing::peak_speed;
  for (const auto [re, wall, inner] :
       {std::array{1275.6, 1.138e-3, 2.60e-2}, {120.8, 6.64e-2, 9.20e-2}}) {
    for (int n : {64}) {
      Annulus a(2.171, n, 0.7, sinusoid(peak, f), at_rest(), 1 / re, 0);
      const double dt = 0.4 * 2.171 / n / 0.7;
      const double period = 1 / f;
      const int steps = static_cast<int>(std::ceil(period / dt));
      double ring = 0, disc = 0;
      const int cycles = re > 500 ? 5 : 2;
      for (int c = 0; c < cycles; ++c) {
        ring = disc = 0;
        for (int s = 0; s < steps; ++s) {
          a.step(period / steps);
          ring += std::pow(a.torque(0), 2) / steps;
          disc += std::pow(a.torque(1), 2) / steps;
        }
        std::printf("Re %g n %d cycle %d ring %.4e (%.4e) disc %.4e (%.4e)\n", re, n, c,
                    std::sqrt(ring), wall, std::sqrt(disc), inner);
      }
    }
  }
}

}  // namespace
}  // namespace washtub
