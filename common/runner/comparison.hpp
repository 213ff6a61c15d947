#pragma once

#include <cstdint>
#include <deque>
#include <functional>
#include <limits>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "common/runner/cadence.hpp"
#include "common/runner/history.hpp"
#include "common/simulation/errors.hpp"
#include "common/simulation/simulation.hpp"

namespace clapotis {

/// One of the two simulations that are compared.
struct Side {
  std::string text;  ///< as the user writes it: STAGE/SCENE:NAME=VALUE,...
  std::string stage_title;
  std::shared_ptr<Simulation> simulation;
  double cpu_seconds = 0;                   ///< of its steps alone
  std::optional<Diverged> divergence = {};  ///< once it has
  History history = {};                     ///< of its rows

  [[nodiscard]] bool runs() const { return !divergence; }
  /// Processor time over simulated time [ms/s]; NaN before the first step.
  [[nodiscard]] double cost() const;
  /// How much the total energy has changed up to the last row, over its amount at the start: the scheme's
  /// error.
  [[nodiscard]] double energy_drift() const;
};

/// Where the side is that is behind, of those that go on [s].
[[nodiscard]] double time_of_both(const Side& left, const Side& right);

/// How far apart the particles of the two sides are, each id with the same id [L].
struct Difference {
  double time = 0;
  double largest = 0, rms = 0;
  Index particle = 0;  ///< the one that is furthest
};

/// Two simulations on a common clock. Neither trajectory is altered: with the same time step they are
/// compared after each step; otherwise at each multiple of `interval`, where a side's positions are those of
/// the cubic that has its positions and velocities before and after the step over that instant (error of
/// order dt^4 between impacts). At a row, a multiple of `interval` at most a step ago, each side waits for
/// the other. Particles are compared while both sides have the same ones.
///
/// The window and headless runs share it: what is compared does not depend on the pieces in which it comes.
class Comparison {
 public:
  /// Throws BadInput when the sides differ in their unit of length. An interval of 0 takes each step of a
  /// short run, some hundred rows of a long one.
  Comparison(Side& left, Side& right, double until, double interval);

  /// Goes on to the next row; false when both sides have reached the end or can go no further.
  bool advance() { return advance_to(std::numeric_limits<double>::infinity()) == Piece::row; }

  enum class Piece { nothing, steps, row };
  /// Goes on to the next row, or, before it, until no step is left that does not go beyond `target` [s]:
  /// `nothing` then.
  Piece advance_to(double target);
  using Allows = std::function<bool()>;
  /// A bounded piece of that: the side that is behind takes from one to `most` steps, none of them beyond
  /// `target` [s], and no second one unless `allows`; or, where both have reached it, the row. `nothing` when
  /// no step is due.
  Piece advance_a_piece(double target, long most, const Allows& allows);

  /// After a change to a side: what it does to the time steps counts from here on.
  void reconsider();
  void end_at(double until) { until_ = until; }

  /// At the row that was reached; none once a side has diverged, or has other particles than the other.
  [[nodiscard]] const std::optional<Difference>& difference() const { return now_; }
  /// Of all instants that were compared, not only of the rows.
  [[nodiscard]] const Difference& largest() const { return largest_; }
  /// Of what the two sides begin with; none where they have other particles.
  [[nodiscard]] const std::optional<Difference>& start() const { return start_; }
  [[nodiscard]] double time() const { return time_; }
  [[nodiscard]] bool steps_together() const { return together_; }
  [[nodiscard]] double interval() const { return interval_; }
  [[nodiscard]] double diagonal() const { return diagonal_; }  ///< of what the scene shows [L]

 private:
  /// The particles of one side at an instant.
  struct Noted {
    double time;
    Vectors positions;
    std::vector<std::int64_t> ids;
  };
  /// One side between two rows.
  struct Trace {
    Side* side;
    bool at_row = false;
    std::deque<Noted> noted;  ///< what the other side has not reached yet
    Vectors position, velocity;
    double time = 0;  ///< of these two: before the step over an instant
  };

  void decide_steps();
  [[nodiscard]] double instant() const;
  [[nodiscard]] bool may_step(const Trace& trace, double target) const;
  void step(Trace& trace) const;
  void note_instant(Trace& trace) const;
  void match();
  Piece finish_row();
  void wait_at_end();

  Trace left_, right_;
  double until_, interval_, diagonal_;
  bool together_ = false, stepped_ = false;
  Cadence rows_{0};
  double time_ = 0;
  std::optional<Difference> now_, start_;
  Difference largest_;
};

/// Greatest and root-mean-square distance between particles of the same id.
Difference distances(const Vectors& left, const Vectors& right, double time);

}  // namespace clapotis
