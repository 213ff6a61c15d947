#pragma once

#include <optional>
#include <vector>

#include "common/lesson/lesson.hpp"
#include "common/simulation/simulation.hpp"

namespace clapotis {

/// What runs gave for each check of an exercise, so far. The same in the window and without one.
class Findings {
 public:
  explicit Findings(const Exercise& exercise) : exercise_(&exercise), found_(exercise.checks.size()) {}

  /// Forgets what that run gave.
  void begin(std::size_t run);
  /// To be called before the first step and after each one: takes what is due at that time.
  void look(std::size_t run, Simulation& simulation, std::string_view side = {});
  /// The run has ended by itself: takes what is asked of its end.
  void end(std::size_t run, Simulation& simulation, std::string_view side = {});
  /// It diverged at that step instead; `simulation` stands on the last good one.
  void diverge(std::size_t run, long step, std::string_view side = {});
  /// Of both sides of a comparison.
  void note(std::size_t run, std::string_view quantity, double value);

  /// What was measured for that check; nothing as long as its run has not come there.
  [[nodiscard]] const std::optional<double>& measured(std::size_t check) const { return found_[check]; }
  /// Whether that run has nothing more to give.
  [[nodiscard]] bool complete(std::size_t run) const;

 private:
  template <class Act>
  void each_open(std::size_t run, std::string_view side, const Act& act);

  const Exercise* exercise_;
  std::vector<std::optional<double>> found_;
};

}  // namespace clapotis
