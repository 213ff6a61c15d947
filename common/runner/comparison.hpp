#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "common/runner/cadence.hpp"
#include "common/runner/history.hpp"
#include "common/simulation/simulation.hpp"

namespace clapotis {

/// One of the two simulations that are compared.
struct Side {
  std::string text;  ///< as the user wrote it: STAGE/SCENE:NAME=VALUE,...
  std::string stage_title;
  std::unique_ptr<Simulation> simulation;
  double cpu_seconds = 0;       ///< of its steps alone
  std::string divergence = {};  ///< the sentence, once it has diverged
  History history = {};

  [[nodiscard]] bool runs() const { return divergence.empty(); }
};

/// How far apart the particles of the two sides are, each id with the same id [L].
struct Difference {
  double time = 0;
  double largest = 0, rms = 0;
  Index particle = 0;  ///< the one that is furthest
};

/// Two simulations on a common clock. Neither trajectory is altered: with the same time step they are
/// compared after each step; otherwise at each multiple of `interval`, where a side's positions are those of
/// the cubic that has its positions and velocities before and after the step over that instant (error of
/// order dt^4 between impacts).
class Comparison {
 public:
  /// Throws BadInput when the sides differ in number of particles or unit of length. An interval of 0 takes
  /// each step of a short run, some hundred rows of a long one.
  Comparison(Side& left, Side& right, double until, double interval);

  /// Goes on to the next row; false when both sides have reached the end or can go no further.
  bool advance();

  /// At the row that was reached; none once a side has diverged.
  [[nodiscard]] const std::optional<Difference>& difference() const { return now_; }
  /// Of all instants that were compared, not only of the rows.
  [[nodiscard]] const Difference& largest() const { return largest_; }
  /// Of what the two sides begin with.
  [[nodiscard]] const Difference& start() const { return start_; }
  [[nodiscard]] double time() const { return time_; }
  [[nodiscard]] bool steps_together() const { return together_; }
  [[nodiscard]] double interval() const { return interval_; }
  [[nodiscard]] double diagonal() const { return diagonal_; }  ///< of what the scene shows [L]

 private:
  struct Trace;
  void follow(Side& side, Trace& trace) const;
  void step_together(Side& side, Trace& trace) const;
  void reach_instant(Side& side, Trace& trace) const;
  void note(const Trace& left, const Trace& right);

  Side &left_, &right_;
  double until_, interval_, diagonal_;
  bool together_;
  Cadence rows_;
  double time_ = 0;
  std::optional<Difference> now_;
  Difference start_, largest_;
};

/// Greatest and root-mean-square distance between particles of the same id.
Difference distances(const Vectors& left, const Vectors& right, double time);

}  // namespace clapotis
