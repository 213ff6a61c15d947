#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "common/runner/compare_picture.hpp"
#include "common/runner/comparison.hpp"

namespace clapotis {

/// The one thing in which the right side differs from the left: the integrator, what a rival of the scene has
/// instead, or a parameter; and the right side's value of it.
struct Contrast {
  std::string name, value;
};

/// What the sides may differ in, the most telling first: integrator, rival, choices, time step, other
/// parameters.
std::vector<std::string> contrasts(const Simulation& left);
/// What the right side may have of it; empty where a number is typed.
std::vector<std::string> contrast_values(const Simulation& left, const std::string& name);
/// What the left side has of it, as text.
std::string value_of(const Simulation& left, const std::string& name);
/// What the scene is compared in as long as nobody chose.
Contrast first_contrast(const Simulation& left);
/// That contrast, with a value for the right side that shows something.
Contrast contrast_in(const Simulation& left, const std::string& name);
/// "ν = 0.02 m²/s", "integrator = rk4".
std::string printed_contrast(const Simulation& left, const Contrast& contrast);

/// The scene twice from one start, on one clock, in pieces that fit into a frame: the comparison that
/// `./lab compare` runs, of a session's simulation, the left side, with another one.
class SideBySide {
 public:
  /// `left` stands at its start. Throws BadInput when the right side cannot be built.
  SideBySide(const Stage& stage, std::shared_ptr<Simulation> left, Contrast contrast);

  /// Lets the common clock go on by `duration` [s], within `budget` seconds of work: false when that was not
  /// enough. What is not done then is forgiven.
  bool advance(double duration, double budget);
  /// One step of the left side, and what the right side takes until then; of the right side alone once the
  /// left has diverged.
  void step();
  /// Brings sides that step together to one instant: call it before a live change to one or both, and
  /// `changed` after it.
  void level();
  void changed() { comparison_.reconsider(); }
  void end_at(double until) { comparison_.end_at(until); }

  [[nodiscard]] const Contrast& contrast() const { return contrast_; }
  [[nodiscard]] Side& left() { return left_; }
  [[nodiscard]] Side& right() { return right_; }
  [[nodiscard]] const Side& left() const { return left_; }
  [[nodiscard]] const Side& right() const { return right_; }
  [[nodiscard]] const Comparison& comparison() const { return comparison_; }
  [[nodiscard]] const Distances& distances() const { return distances_; }
  [[nodiscard]] bool runs() const { return left_.runs() || right_.runs(); }
  /// Where the side is that is behind [s].
  [[nodiscard]] double time() const { return time_of_both(left_, right_); }

 private:
  Comparison::Piece advance_a_piece(const Comparison::Allows& allows);

  Contrast contrast_;
  Side left_, right_;
  Comparison comparison_;
  Distances distances_;
  double clock_ = 0;  ///< beyond which no side goes [s]
};

}  // namespace clapotis
