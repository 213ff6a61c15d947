#pragma once

#include <functional>
#include <limits>
#include <memory>
#include <string>
#include <vector>

#include "common/integrators/integrator.hpp"
#include "common/measures/energy.hpp"
#include "common/simulation/scene.hpp"
#include "common/simulation/state_bytes.hpp"

namespace clapotis {

/// Where the time of the loop went [s].
struct Cost {
  double neighbours = 0, density = 0, forces = 0, integration = 0, walls = 0;
};

/// A scene that runs: the only time loop there is. Window, headless runs, tests, studies and comparisons call
/// `step`.
class Simulation {
 public:
  /// Builds the scene. Throws BadInput when a value or a name is not allowed; nothing has run then.
  Simulation(const Scene& scene, const Overrides& overrides = {},
             std::string_view integrator = default_integrator, int threads = 1);
  ~Simulation();
  Simulation(const Simulation&) = delete;
  Simulation& operator=(const Simulation&) = delete;

  /// One time step, shortened when it would pass `until`. Throws Diverged, standing on the last good state.
  void step(double until = std::numeric_limits<double>::infinity());

  /// Changes a live parameter while the scene runs; throws BadInput, and changes nothing then. A parameter
  /// that needs a restart is changed by building a new Simulation from `parameters().overrides()`.
  void set(std::string_view name, std::string_view value, Origin origin = Origin::window);
  void use_integrator(std::string_view name);
  /// Changes the state by hand, between two steps; `change` may add and remove particles and obstacles. The
  /// energy that it brings counts as negative dissipation, and there is no reference any more.
  void edit(const std::function<void(System&)>& change);

  /// Writes all that the next steps depend on, or reads it: the run then goes on from there with the bits
  /// that it would have had. Reading is for a simulation built from the same scene, `built_from` and
  /// integrator, by the same program, however far it has run; it throws ForeignState otherwise, or BadInput,
  /// and is of no use then.
  void pass_state(StateBytes& state);
  /// How often somebody stepped in: what a run comes to from one state on depends on nothing else.
  [[nodiscard]] long interventions() const { return interventions_; }

  /// Calls `look` with accelerations that belong to the positions and velocities as they stand, without the
  /// walls' reaction; what follows is as if nobody had looked.
  void look(const std::function<void(const System&)>& look);

  /// Whether the next step is the one that ends at `until`, altered so that it does.
  [[nodiscard]] bool next_ends_at(double until) const { return until - time() < dt_ * (1 + 1e-9); }

  [[nodiscard]] double time() const { return system_->time; }
  [[nodiscard]] long steps() const { return steps_; }
  [[nodiscard]] double dt() const { return dt_; }        ///< of the next step
  [[nodiscard]] const StepLimit& binding_limit() const;  ///< that sets dt, or that dt is measured by
  [[nodiscard]] const std::vector<StepLimit>& limits() const { return limits_; }
  [[nodiscard]] Energy energy() { return clapotis::energy(*system_); }
  /// Error against the reference; NaN without one.
  [[nodiscard]] double error() const;
  [[nodiscard]] std::vector<std::string> warnings() const;
  [[nodiscard]] const Cost& cost() const { return cost_; }
  [[nodiscard]] double sound_speed() const { return sound_speed_; }  ///< of the fluid, or c = 10 v_max [L/s]
  /// What sound travels one of in h/c: the smoothing length of a fluid, or the radius [L].
  [[nodiscard]] double smoothing_length() const { return setup_.fluid ? setup_.fluid->h : setup_.radius; }

  [[nodiscard]] System& system() { return *system_; }
  [[nodiscard]] const System& system() const { return *system_; }
  [[nodiscard]] const Particles& particles() const { return system_->particles; }
  [[nodiscard]] Model& model() { return *setup_.model; }
  [[nodiscard]] const Model& model() const { return *setup_.model; }
  [[nodiscard]] const Setup& setup() const { return setup_; }
  [[nodiscard]] const Scene& scene() const { return scene_; }
  [[nodiscard]] const Parameters& parameters() const { return parameters_; }
  /// What the user had asked for when the scene was built; live changes since then are not in it.
  [[nodiscard]] const Overrides& built_from() const { return built_from_; }
  [[nodiscard]] const std::string& integrator() const { return integrator_name_; }
  [[nodiscard]] bool controls_error() const { return integrator_->controls_error(); }
  [[nodiscard]] int threads() const { return particles().threads; }
  /// Memory of the columns and of the model, over the number of particles [byte].
  [[nodiscard]] double bytes_per_particle() const;

 private:
  struct Checkpoint;
  /// Steps of one length are counted, so that a million of them leave no error of a million roundings.
  struct Clock {
    double start = 0, dt = 0;  ///< when the first of them began, and their length [s]
    long steps = 0;
  };

  void choose_step();
  void bound_speed();
  void advance(double dt);
  void check(double dt);
  void keep();
  void go_back(long steps);
  void note_change(std::string_view name, std::string_view value, Origin origin);
  void pass_changes(StateBytes& state);

  /// A live change since the scene was built.
  struct LiveChange {
    std::string name, value;
    Origin origin = Origin::window;
  };

  Scene scene_;
  Overrides built_from_;
  Parameters parameters_;
  std::optional<Parameters> unchanged_;  ///< as they were before the first live change
  Setup setup_;
  std::optional<Reference> reference_;  ///< that the scene has, as long as nobody steps in
  std::unique_ptr<System> system_;
  std::string integrator_name_;
  std::unique_ptr<Integrator> integrator_;
  std::vector<StepLimit> limits_;
  double dt_ = 0, sound_speed_ = 0;
  double fastest_ = 0;  ///< a particle beyond this speed has gained energy from nowhere; 0: unknown [L/s]
  long steps_ = 0, interventions_ = 0;
  Clock clock_;
  std::unique_ptr<Checkpoint> checkpoint_;
  std::vector<double> taken_;  ///< the steps since the checkpoint [s]
  Cost cost_;
  std::vector<std::string> warnings_;
  std::vector<LiveChange> changes_;  ///< the last of each parameter, in their order
};

}  // namespace clapotis
