#pragma once

#include <array>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <utility>

#include "common/runner/history.hpp"
#include "common/runner/options.hpp"
#include "common/simulation/errors.hpp"
#include "common/simulation/simulation.hpp"
#include "common/window/pacer.hpp"
#include "common/window/past.hpp"
#include "common/window/side_by_side.hpp"

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
  /// Starts what a command line asks for, as if the window had been opened with it.
  void begin(const Options& options);
  /// What is to be called after each step; nothing for an empty function.
  void watch(std::function<void(Simulation&)> after_step) { after_step_ = std::move(after_step); }
  /// Goes on from a saved state of this stage. Throws FileError when it does not fit.
  void restore(const SavedState& saved);

  // The same scene a second time, beside the first: see SideBySide. All that is asked of the session counts
  // for both sides, except where they differ; each of these starts both anew.
  void toggle_side_by_side();                   ///< off: the left side goes on alone
  void differ_in(const std::string& contrast);  ///< an integrator, a rival, a parameter
  /// Both at once: from --beside. Throws BadInput for what the scene cannot differ in.
  void put_beside(const std::string& contrast, const std::string& value);
  void choose_other(const std::string& value);  ///< the right side's
  /// Acts on the simulation, and on the right side where there is one: what a hand does.
  void act_on_both(const std::function<void(Simulation&)>& act);
  [[nodiscard]] SideBySide* sides() { return sides_.get(); }
  [[nodiscard]] const SideBySide* sides() const { return sides_.get(); }

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
  /// Whether nothing can go on: with two sides, when both have diverged.
  [[nodiscard]] bool stopped() const { return sides_ ? !sides_->runs() : diverged_.has_value(); }
  /// Of the side that is behind [s].
  [[nodiscard]] double time() const { return sides_ ? sides_->time() : simulation_->time(); }
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
  void play(std::shared_ptr<Simulation> simulation);
  [[nodiscard]] Contrast contrast_for(const Simulation& left) const;
  void choose(const Contrast& contrast);
  void start_sides(const Contrast& contrast);
  void set_both(const std::string& parameter, const std::string& value);
  bool step_once();
  template <class Act>
  void act_on_sides(const Act& act);
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
  std::function<void(Simulation&)> after_step_;
  std::optional<double> until_;      ///< --until: pause at that simulated time [s]
  std::optional<long> steps_until_;  ///< --steps: pause after so many
  std::size_t scene_ = 0;
  std::shared_ptr<Simulation> simulation_;
  std::unique_ptr<Parameters> defaults_;
  History history_;
  Past past_;
  Pacer pacer_;
  std::string preset_;
  bool paused_ = false;
  int octaves_ = 0;
  std::optional<Diverged> diverged_;
  std::unique_ptr<SideBySide> sides_;  ///< none: the simulation is alone
  std::optional<Contrast> contrast_;   ///< that the user chose
  long starts_ = 0, leaps_ = 0;
  Work work_;
};

}  // namespace clapotis
