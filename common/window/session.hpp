#pragma once

#include <array>
#include <memory>
#include <optional>
#include <string>

#include "common/runner/history.hpp"
#include "common/runner/options.hpp"
#include "common/simulation/errors.hpp"
#include "common/simulation/simulation.hpp"
#include "common/window/pacer.hpp"
#include "common/window/past.hpp"

namespace clapotis {

/// A stage as it is played in the window: one simulation, and what the user can ask of it. Knows no window.
/// What cannot be done throws BadInput and changes nothing.
class Session {
 public:
  /// `stage` must outlive the session. Throws BadInput as Simulation does.
  Session(const Stage& stage, const Options& options);

  void toggle_pause() { paused_ = !paused_; }
  void step(int count);  ///< that many steps, and pauses
  /// As many steps back as are kept, and pauses; a run that diverged stands on its last good state no more.
  void step_back(int count);
  /// To the last step kept that is not later [s], and pauses.
  void go_to(double time);
  void reset();  ///< from the start, with the parameters and the seed as they are now
  void change_speed(int octaves);
  void choose_scene(std::size_t scene);
  /// From the start, with half the time step.
  void halve_step();
  [[nodiscard]] double half_step() const;           ///< that step, rounded to two digits [s]
  void choose_integrator(const std::string& name);  ///< goes on with it; from the start after a divergence
  void set(const std::string& parameter, const std::string& value);  ///< restarts the scene when it must
  void choose_preset(const std::string& name);  ///< of the scene, which restarts with its values
  void restore_defaults();                      ///< of all parameters; restarts the scene
  /// Goes on from a saved state of this stage. Throws FileError when it does not fit.
  void restore(const SavedState& saved);

  /// What a frame does: the steps that are due after `elapsed` seconds, at least one of them, and no new one
  /// once `budget` seconds of work are spent.
  void advance(double elapsed, double budget);

  [[nodiscard]] const Stage& stage() const { return stage_; }
  [[nodiscard]] std::size_t scene() const { return scene_; }
  [[nodiscard]] Simulation& simulation() { return *simulation_; }
  [[nodiscard]] const Simulation& simulation() const { return *simulation_; }
  [[nodiscard]] const History& history() const { return history_; }
  /// The parameters as the scene and its laws give them.
  [[nodiscard]] const Parameters& defaults() const { return *defaults_; }
  /// The preset that was chosen, as long as nothing but live parameters has changed since; empty otherwise.
  [[nodiscard]] const std::string& preset() const { return preset_; }
  [[nodiscard]] bool paused() const { return paused_; }
  [[nodiscard]] double speed() const;  ///< simulated seconds per second, as asked
  /// Why the run stopped; the simulation stands on its last good state until it starts anew.
  [[nodiscard]] const std::optional<Diverged>& diverged() const { return diverged_; }
  /// How often a scene was started: a new number means that particles and parameters may be others.
  [[nodiscard]] long starts() const { return starts_; }
  /// How often time leapt: a scene that started, a way back.
  [[nodiscard]] long leaps() const { return leaps_; }
  [[nodiscard]] const Past& past() const { return past_; }

  /// What the last `advance` or `step` did.
  struct Work {
    long steps = 0;
    double seconds = 0;         ///< of real time, for these steps
    double simulated = 0;       ///< [s]
    bool within_budget = true;  ///< false: slower than asked
  };
  [[nodiscard]] const Work& work() const { return work_; }

 private:
  void start(std::size_t scene, const Overrides& overrides, const std::string& integrator);
  void play(std::unique_ptr<Simulation> simulation);
  bool step_once();
  bool reached_end() const;
  void leave_known_time();
  void keep_end();
  void return_to(long step);
  void note_work(double start);
  /// All simulations of the session: they share one past.
  [[nodiscard]] std::array<Simulation*, 1> shown() const { return {simulation_.get()}; }

  const Stage& stage_;
  Overrides given_;  ///< on the command line: every scene that has such a parameter starts with it
  int threads_;
  std::optional<double> until_;      ///< --until: pause at that simulated time [s]
  std::optional<long> steps_until_;  ///< --steps: pause after so many
  std::size_t scene_ = 0;
  std::unique_ptr<Simulation> simulation_;
  std::unique_ptr<Parameters> defaults_;
  History history_;
  Past past_;
  Pacer pacer_;
  std::string preset_;
  bool paused_ = false;
  int octaves_ = 0;
  std::optional<Diverged> diverged_;
  long starts_ = 0, leaps_ = 0;
  Work work_;
};

}  // namespace clapotis
