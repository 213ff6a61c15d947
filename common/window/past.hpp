#pragma once

#include <cstddef>
#include <deque>
#include <span>
#include <string>
#include <vector>

#include "common/simulation/simulation.hpp"

namespace clapotis {

/// A run's past, in bounded memory: states of one simulation, or of several that are shown at the same
/// instants, at some of its steps. Between two of them nobody stepped in, so that the steps from one on give
/// the bits of the other. Steps are those of the first simulation.
class Past {
 public:
  using Simulations = std::span<Simulation* const>;
  struct Bounds {
    std::size_t bytes = std::size_t{200} << 20;
    std::size_t moments = 4096;
    double apart = 0.02;       ///< a moment is kept after so much work [s]
    double most_apart = 0.05;  ///< ... and no more lies between two of the older half [s]
  };
  Past() = default;
  explicit Past(const Bounds& bounds) : bounds_(bounds) {}

  /// Forgets all, and begins with the present.
  void begin(Simulations present);
  /// New steps came to the present, with so much work [s]: keeps it when enough has gathered.
  void pass(Simulations present, double work);
  /// Keeps the present as the newest moment, unless it is that: what lay beyond it goes.
  void keep(Simulations present);
  /// Whether somebody stepped in since the present was kept or restored.
  [[nodiscard]] bool changed(Simulations present) const;

  struct Instant {
    long step = 0;
    double time = 0;  ///< [s]
  };
  [[nodiscard]] Instant oldest() const { return moments_.front().at; }
  [[nodiscard]] Instant newest() const { return moments_.back().at; }
  /// The last moment kept that is not after it, or the oldest one.
  [[nodiscard]] Instant before(long step) const;
  [[nodiscard]] Instant before(double time) const;
  /// Brings the simulations back to `before(step)`. They are those that were kept, since none of them began
  /// anew.
  void restore(Simulations simulations, long step);

  [[nodiscard]] std::size_t size() const { return moments_.size(); }
  [[nodiscard]] std::size_t bytes() const { return bytes_; }

 private:
  struct Moment {
    Instant at;
    double work = 0;          ///< since the moment before [s]
    bool intervened = false;  ///< steps from the moment before do not lead here
    struct State {
      std::string integrator, bytes;
    };
    std::vector<State> states;
  };
  using Moments = std::deque<Moment>;

  [[nodiscard]] std::vector<Moment::State> copies(Simulations present);
  void drop(Moments::iterator moment);
  void reuse(Moment& moment);
  void make_room();

  Bounds bounds_;
  Moments moments_;
  std::size_t bytes_ = 0;
  double work_ = 0;  ///< since the newest moment [s]
  long interventions_ = 0;
  std::vector<std::string> used_;  ///< memory of dropped states, for the next ones: fresh pages cost most
};

}  // namespace clapotis
