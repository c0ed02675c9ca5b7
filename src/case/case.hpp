#pragma once
#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "base/vec.hpp"
#include "case/readings.hpp"
#include "cloth/material.hpp"
#include "contact/settings.hpp"
#include "coupling/kernel.hpp"
#include "coupling/scheme.hpp"
#include "solid/drive.hpp"
#include "solid/shape.hpp"

namespace washtub {

struct FluidCase {
  double density = 1000;   ///< rho_f [kg/m^3]
  double viscosity = 1.0;  ///< dynamic viscosity mu [Pa s]
  /// Pulls at what cloth weighs more than the water it displaces [m/s^2]; in the water itself it
  /// only adds to the pressure.
  Vec<3> gravity = Vec<3>::Zero();
  std::array<std::string, 3> velocity = {"0", "0", "0"};  ///< at t = 0: formulas of x, y, z, r
};

enum class SideKind { no_slip, slip, moving_wall, periodic, inflow, outflow, far_field };
std::string side_name(SideKind kind);  ///< "no-slip"

/// Condition on one side of the box.
struct SideCase {
  SideKind kind = SideKind::no_slip;
  Vec<3> velocity = Vec<3>::Zero();  ///< of a moving wall, tangential, or of the inflow [m/s]
};

enum class Mapping { sharp, smooth, gradual };
std::string mapping_name(Mapping mapping);  ///< "sharp"

struct DomainCase {
  Vec<3> lower = Vec<3>::Zero();  ///< lower corner of the box [m]
  Vec<3> size = Vec<3>::Zero();   ///< edge lengths [m]; third one unused in 2-D
  std::array<int, 3> cells = {0, 0, 1};
  std::array<SideCase, 6> sides;     ///< x lower, x upper, y lower, ...
  Mapping mapping = Mapping::sharp;  ///< Heaviside function of Eq. (9)
  double mapping_width = 2;          ///< gamma of Eq. (11), in cells; smooth mapping only
  double mapping_shift = 0;          ///< see DomainMapping; sharp mapping only
};

/// A rigid solid: a shape in its body frame, placed at `centre`, turning about z through it.
struct SolidCase {
  std::string name;
  Shape shape;
  Vec<3> centre = Vec<3>::Zero();  ///< [m]
  Drive drive = at_rest();
};

enum class Arrangement { book, random, dropped, layers, sheet, ring };

/// An edge of a sheet: where r or s is least or largest.
enum class Edge { r_lower, r_upper, s_lower, s_upper };

/// A group of equal pieces of cloth.
struct ClothCase {
  std::string name;    ///< of the group
  std::string fabric;  ///< that gave what the file does not; "" for none
  int count = 1;
  std::array<double, 2> size = {0, 0};  ///< edge lengths (r, s) [m]
  std::array<int, 2> nodes = {0, 0};    ///< nodes along r and s; 0 = from `spacing`
  double spacing = 1.7;                 ///< node spacing in lateral cells, where `nodes` is 0
  /// Of wet cloth in general, where nothing else is given.
  Material material = {.friction = 0.5, .solid_friction = 0.2, .loss_time = 1e-3};
  /// Pulls at the cloth, over its area at rest: formulas of x, y, z, r, t [Pa].
  std::array<std::string, 3> load = {"0", "0", "0"};
  double air_permeability = 0;  ///< of air at 100 Pa [m/s]; 0 = not known
  double areal_mass = 0;        ///< dry [kg/m^2]; 0 = not known
  double fibre_density = 1540;  ///< that of cotton [kg/m^3]
  std::optional<KesReadings> kes;
  std::optional<FastReadings> fast;
  Arrangement arrangement = Arrangement::book;
  std::uint64_t seed = 1;
  /// book: pages in planes through the axis (reference.md, start of the 3-D wash)
  double inner_radius = 0;  ///< radial position of the inner edge [m]
  double bottom = 0;        ///< height of the lower edge [m]
  double shift = 0;         ///< standard deviation of the random shift [m]
  double tilt = 0;          ///< standard deviation of the random tilt [rad]
  /// book, random, dropped, layers: as a packet of so many layers along r and s, or crumpled to a
  /// part of its size
  std::array<int, 2> folded = {1, 1};
  double crumpled = 0;   ///< part of the extent that is lost
  double clearance = 0;  ///< smallest distance to solids, surface and other pieces [m]
  double curvature =
      0;  ///< random, dropped, sheet: at the start, along r; the rest state is flat [1/m]
  /// sheet: one piece (count is 1) spanned from `origin` along two directions
  Vec<3> origin = Vec<3>::Zero();  ///< [m]
  std::array<Vec<3>, 2> along = {Vec<3>::UnitX(), Vec<3>::UnitY()};
  std::array<bool, 2> closed = {false, false};  ///< along r, s: spans a periodic box
  std::vector<Edge> pinned;                     ///< one row of nodes does not move
  std::vector<Edge> clamped;  ///< two rows do not move; the clamp acts midway between them
  /// ring: one closed thread (2-D, count is 1) whose rest length is size[0]
  Vec<3> centre = Vec<3>::Zero();  ///< [m]
  double radius = 0;               ///< [m]
  /// sheet, ring: normal displacement ripple sin(2 pi ripples r/L) (ring: cos, outwards)
  double ripple = 0;   ///< [m]
  double ripples = 1;  ///< waves along r
};

/// A node of cloth whose place is written to the history.
struct ProbeCase {
  std::string name;
  int piece = 1;                     ///< among all pieces, from 1
  std::array<int, 2> node = {0, 0};  ///< (i, j) along r and s, from 0; below 0 from the end
};

/// A known solution that the velocity is compared with.
struct ExactCase {
  std::array<std::string, 3> velocity = {"0", "0", "0"};  ///< formulas of x, y, z, r, t [m/s]
  bool relative = false;  ///< errors over the exact speed at each face, Eq. (A.13)
};

struct CouplingCase {
  Scheme scheme = Scheme::implicit;
  Kernel kernel = Kernel::roma3;
  double marker_spacing = 1.5;  ///< largest distance between markers, in smallest cell edges
  double strain_limit = 0.2;    ///< |E| of an edge at which the run stops
};

struct ContactCase {
  ContactScheme scheme = ContactScheme::layers;
  double range = 0;          ///< [m]; 0 while it is not known
  double pressure = -1;      ///< [Pa]; below 0 likewise
  double gap = 0;            ///< [m]; 0 likewise
  double solid_time = 6e-3;  ///< [s]
  bool untangle = false;     ///< pieces that start too near to each other are moved apart
};

/// What moves the cloth before t = 0, while all solids rest.
struct SettleCase {
  double time = -1;                 ///< that takes at most [s]; below 0 while it is not known
  Vec<3> gravity = Vec<3>::Zero();  ///< [m/s^2]; zero while it is not known
};

struct TimeCase {
  double end = 0;      ///< [s]
  double cfl = 0.3;    ///< advective limit
  double step = 0;     ///< upper bound of the time step [s]; 0 = none
  bool fixed = false;  ///< take `step` as it is, whatever the CFL number
};

struct SolverCase {
  double divergence = 1e-4;  ///< stop when |div u| h/U is below this in every fluid cell
  int max_cycles = 60;
};

struct OutputCase {
  double every = 0;           ///< sample interval of history.csv [s]
  double frames = 0;          ///< interval of frames [s]; 0 = none
  double window_begin = 0;    ///< start of the statistics [s]
  double window_end = 0;      ///< end of the statistics [s]
  double stress_time = 8e-3;  ///< over which strains are low-passed [s]
};

struct CheckpointCase {
  double every = 0;        ///< simulated time between checkpoints [s]; 0 = none
  double wall_time = 600;  ///< time of computing between checkpoints [s]; 0 = none
  int keep = 2;            ///< newest ones that stay
};

/// Scales of the dimensionless groups, Eqs. (17)-(19).
struct ScaleCase {
  double length = 0;  ///< r_o [m]
  double speed = 0;   ///< omega_max [rad/s]; 0 = none
  double height = 0;  ///< H [m]; 1 in 2-D
  double period = 0;  ///< of the drive [s]; 0 = none
};

/// All that a simulation needs, in SI units, valid and complete.
struct Case {
  std::string title;  ///< with the keys that --set changed
  int dimension = 3;
  FluidCase fluid;
  DomainCase domain;
  std::vector<SolidCase> solids;
  std::vector<ClothCase> cloth;
  std::vector<ProbeCase> probes;
  std::optional<ExactCase> exact;
  CouplingCase coupling;
  ContactCase contact;
  SettleCase settle;
  TimeCase time;
  SolverCase solver;
  OutputCase output;
  CheckpointCase checkpoint;
  ScaleCase scale;
  std::string resolved;            ///< the case as TOML with explicit units, defaults filled in
  std::vector<std::string> notes;  ///< what the user should know, a sentence each
};

/// Contact with what is not given filled in.
ContactCase complete_contact(const Case& whole);

constexpr int most_nodes = 4096;  ///< along an edge of a piece

/// Nodes along r and s: as given, or from `spacing` in lateral cells; {n, 1} in 2-D. No count above
/// `most_nodes` is told from others.
std::array<int, 2> cloth_nodes(const ClothCase& cloth, const Case& whole);
/// Distances between them at rest [m]: as many as there are intervals make up the size, where a
/// clamp counts half an interval less and a closed direction one more. 0 where there is one node.
std::array<double, 2> cloth_spacing(const ClothCase& cloth, const Case& whole);
/// Intervals along r (0) or s (1) that make up the size: 0.5 less for each clamp.
double intervals(const ClothCase& cloth, int direction, int nodes);
/// Extent of a piece as it starts, folded and crumpled [m].
double start_extent(const ClothCase& cloth, int direction);
bool is_held(const std::vector<Edge>& held, int direction, int end);

/// Reads, completes and validates a case file.
/// `settings` are "key=value" overrides as given by `--set`.
/// @throws InputError with file, line, key, allowed values and nearest known name.
Case read_case(const std::string& path, const std::vector<std::string>& settings = {});
/// The same of the text of a file called `name`.
Case read_case_text(const std::string& text, const std::string& name,
                    const std::vector<std::string>& settings = {});

/// The input reference, one line per key, in Markdown, from the same declarations.
std::string input_reference();

/// JSON schema of a case file, from the same declarations.
std::string case_schema();

}  // namespace washtub
