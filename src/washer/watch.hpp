#pragma once
#include <optional>
#include <string>

#include "base/error.hpp"
#include "case/case.hpp"
#include "cloth/cloth.hpp"
#include "flow/flow.hpp"

namespace washtub {

/// Bounds beyond which a state makes no sense any more; that of strain is the case's.
struct WatchLimits {
  double courant = 1;        ///< CFL number of a fixed step: beyond it convection is unstable
  double divergence = 0.01;  ///< root mean square of |div u| h/U that the pressure solve may leave
  double slip = 0.5;         ///< rms slip of the cloth over the speed of what drives the water
  double speed = 10;         ///< of the water over that of what drives it
};

/// What a step tells of itself.
struct StepHealth {
  long number = 0;
  double time = 0;           ///< after the step [s]
  double dt = 0;             ///< [s]
  double courant = 0;        ///< CFL number
  double divergence = 0;     ///< root mean square of |div u| h/U left
  bool converged = true;     ///< the pressure solve
  int cycles = 0;            ///< of the pressure solve
  double speed = 0;          ///< largest velocity component [m/s]
  double kinetic = 0;        ///< energy of the water [J]
  double strain = 0;         ///< largest |E|
  double slip = 0;           ///< rms over the nodes [m/s]
  double driving_speed = 0;  ///< of the fastest surface, side or inflow [m/s]; 0: unknown
};

enum class TroubleKind { not_finite, pressure, courant, strain, slip, speed };

/// The pressure solve is what keeps a run from going on: more cycles may help.
class PressureError : public RunError {
 public:
  using RunError::RunError;
};

/// Why a run cannot go on, in one paragraph: when, what, where, measured, allowed, what to try.
struct Trouble {
  TroubleKind kind;
  std::string text;
};

/// The first thing wrong with a step, if anything; the causes come before their effects. Collective
/// where there is trouble, and then all ranks find the same.
template <int D>
std::optional<Trouble> find_trouble(const StepHealth& step, const Flow<D>& flow,
                                    const Cloth<D>& cloth, const Case& whole,
                                    const WatchLimits& limits = {});

}  // namespace washtub
