#pragma once

#include <array>
#include <optional>
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

#include "common/language.hpp"

namespace clapotis {

/// What a run has to give, as the README says it: "run 2 at t = 0.4 s: error = 2.6e-3 m within 5 %".
struct Check {
  enum class Relation { equal, below, above };

  std::size_t run = 0;         ///< its place in the exercise
  std::string side;            ///< "left" or "right" of a comparison; empty of the run, or of both
  std::string quantity;        ///< see `measure`
  std::optional<double> time;  ///< at the first state that reaches it [s]; else at the end
  Relation relation = Relation::equal;
  double value = 0;
  double tolerance = 0;  ///< of `equal`, as a share of the value; 0: exactly
  std::string unit;
  int line = 0;  ///< of the README

  [[nodiscard]] bool holds(double measured) const;
};

/// One line of what is to be run.
struct LessonRun {
  enum class Kind { run, compare, other };

  Kind kind = Kind::other;
  std::string text;                ///< the whole line
  std::vector<std::string> words;  ///< of it, behind "./lab run STAGE" or "./lab compare"
  std::string stage;               ///< of a run
  int line = 0;

  /// What it does, in a line for the panel: "drop, rk4, dt=0.002, t = 0.4 s".
  [[nodiscard]] std::string summary() const;
};

/// The sentences of an exercise, without the marks of the form. An empty line parts paragraphs.
struct Wording {
  std::string title, predict, explain;
};

struct Exercise {
  std::array<Wording, 2> in;  ///< by language
  std::vector<LessonRun> runs;
  std::vector<Check> checks;

  [[nodiscard]] const Wording& wording() const { return in[static_cast<std::size_t>(language())]; }
};

/// A text that does not follow the form; the message has its name and line.
struct LessonError : std::runtime_error {
  using std::runtime_error::runtime_error;
};

/// The exercises of a stage. Their form, in the section "## Predict, run, explain" of README.md:
///
///     ### 1. Title
///     **Predict.** What is asked.
///
///     **Run.**
///     ```
///     ./lab run STAGE SCENE [OPTION...]
///     ./lab compare LEFT RIGHT [OPTION...]
///     ```
///     What a reader without a window is to look at.
///
///     **Check.**
///     - run 1 at t = 0.4 s: error = 5.3e-3 m within 5 %
///     - run 2 left: force_evaluations < 100
///
///     **Explain.** The answer.
///
/// exercises.fr.md has the same exercises in the same order, each with its title, **Prévoir.** and
/// **Expliquer.** Throws LessonError.
std::vector<Exercise> read_lesson(std::string_view readme, std::string_view french);

/// The exercises of the stage of that name, as they stood when this was built; none where it has none.
const std::vector<Exercise>& lesson_of(std::string_view stage);

}  // namespace clapotis
