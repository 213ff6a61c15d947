#pragma once

#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "common/laws/walls.hpp"
#include "common/particles/particles.hpp"

namespace clapotis {

struct System;
struct DummyWalls;
struct Hand;
class Parameters;
class StateBytes;

/// The largest time step that something in the scene allows, and the share of it that `dt = auto` takes.
struct StepLimit {
  std::string name;       ///< for example "acoustic", "contact"
  std::string formula;    ///< for example "h/c"
  double limit;           ///< [s]
  double share;           ///< dt = auto is the smallest share x limit
  bool stability = true;  ///< beyond it the run diverges; otherwise it only becomes less accurate
};

/// Energies per unit depth at one instant.
struct StoredEnergy {
  double potential = 0;  ///< weight, and a liquid's surface
  double elastic = 0;    ///< springs
  double internal = 0;   ///< compression of a fluid
};

/// Time that evaluations took, by phase [s].
struct PhaseSeconds {
  double neighbours = 0, density = 0, walls = 0, forces = 0;

  [[nodiscard]] double total() const { return neighbours + density + walls + forces; }
};

/// The particles that touch or nearly touch one particle, for the eye.
struct Neighbourhood {
  double support = 0;             ///< beyond this distance nothing acts [L]
  Vector cell{0, 0};              ///< sides of a cell; 0 without a grid [L]
  Vector origin{0, 0};            ///< lower left corner of the grid
  Corners visited;                ///< the cells that were looked through; empty without a grid
  std::vector<Index> candidates;  ///< tested
  std::vector<Index> neighbours;  ///< within the support
};

/// A law that acts on particles, and what it does to one of them.
struct ActingLaw {
  std::string_view name;
  Vector acceleration;  ///< [L/s^2]
};

/// A smoothing kernel at work around one particle, for the eye.
struct KernelAround {
  struct Neighbour {
    Vector separation;  ///< r_i - r_j, or of the image that is near [L]
    double volume;      ///< V_j, per unit of depth [L^2]
    bool wall;          ///< whether it is a particle of a wall
  };
  double h = 0, support = 0;                 ///< smoothing length, and where W ends [L]
  std::function<double(double)> value = {};  ///< W(r) [1/L^2]
  std::function<double(double)> slope = {};  ///< W'(r) [1/L^3]
  std::vector<Neighbour> neighbours = {};    ///< within the support, the particle itself included
};

struct PairCount {
  long long candidates = 0;  ///< ordered pairs tested
  long long neighbours = 0;  ///< ordered pairs within the support
};

/// All laws of a scene behind one border: integrators, runner and window know nothing else of them.
class Model {
 public:
  virtual ~Model() = default;

  /// Sum of all laws at time t: fills acceleration and dissipation.
  virtual void evaluate(System& system, double t) = 0;
  /// Fills density_rate and diffusion, in a model whose density follows from the equation of continuity.
  virtual void evaluate_density_rate(System& /*system*/) {}
  /// After each step: walls. The only place where a state is changed other than by the integrator.
  virtual void settle(System& system, double dt) = 0;
  /// Reads the parameters again, after one of them changed.
  virtual void refresh(Parameters& parameters) = 0;
  /// Writes or reads what the next steps depend on besides particles and parameters. Most models remember
  /// nothing.
  virtual void pass_state(StateBytes& /*state*/) {}

  [[nodiscard]] virtual StoredEnergy stored_energy(const Particles& particles) = 0;
  [[nodiscard]] virtual std::vector<StepLimit> limits(const Particles& particles) const = 0;
  /// Whether the limits depend on speeds and accelerations, so that each step has its own dt.
  [[nodiscard]] virtual bool limits_follow_state() const { return false; }
  [[nodiscard]] virtual std::vector<std::string> laws() const = 0;
  /// The walls, for the picture and for impacts located inside a step.
  [[nodiscard]] virtual std::optional<Walls> walls() const = 0;

  /// The particles that walls are made of; null where there are none.
  [[nodiscard]] virtual const DummyWalls* wall_particles() const { return nullptr; }

  /// The hand in the liquid; null in a scene without one.
  [[nodiscard]] virtual Hand* hand() { return nullptr; }
  [[nodiscard]] const Hand* hand() const { return const_cast<Model*>(this)->hand(); }
  /// Where the particles of drawn obstacles are [L]; they act as those of the walls do.
  [[nodiscard]] virtual Vectors obstacles() const { return Vectors(0, 2); }
  virtual void put_obstacles(const Vectors& /*places*/) {}
  /// Whether liquid enters or leaves.
  [[nodiscard]] virtual bool has_open_ends() const { return false; }
  /// curl v at each particle of a liquid [1/s]; none elsewhere.
  [[nodiscard]] virtual Column vorticity(const Particles& /*particles*/) { return {}; }

  /// Seconds of one evaluation of each law alone on the state as it stands: the median of `repetitions`.
  [[nodiscard]] virtual std::vector<double> law_seconds(const System& system, int repetitions) = 0;
  /// Who was tested for particle i, and who is near it; empty where no law acts between pairs.
  [[nodiscard]] virtual std::optional<Neighbourhood> neighbourhood(const Particles& particles, Index i) = 0;

  // Three looks inside particle i. They are of the state of the last `evaluate` of the whole System, as it is
  // within Simulation::look, and cost a look at its neighbours.

  /// What each law that acts on particles gives it, in the order of `laws()`. Their sum is its acceleration,
  /// but for the rounding of sums in another order, and for an implicit law: that one counts with the
  /// velocities as they stand, which are those it made at the end of the last step. Nothing acts on a
  /// particle that open ends hold.
  [[nodiscard]] virtual std::vector<ActingLaw> accelerations_by_law(const System& system, Index i) = 0;
  /// The kernel and all that it weighs; none in a scene without one.
  [[nodiscard]] virtual std::optional<KernelAround> kernel_around(Index /*i*/) { return std::nullopt; }
  /// What another particle like it, at a distance r, would do to it; positive pushes apart [L/s^2].
  [[nodiscard]] virtual double push_at(double /*r*/, Index /*i*/) { return 0; }

  [[nodiscard]] virtual PairCount count_pairs(const Particles& particles) = 0;

  /// Memory besides the particles' columns [byte].
  [[nodiscard]] virtual std::size_t bytes() const = 0;
  [[nodiscard]] virtual bool has_pairs() const = 0;

  PhaseSeconds seconds;  ///< spent while `timed` was set
  bool timed = false;
  long long coincident = 0;  ///< pairs met at one point so far
  long long folded = 0;      ///< reflections beyond one box in one step so far
};

}  // namespace clapotis
