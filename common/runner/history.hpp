#pragma once

#include <limits>
#include <string>
#include <string_view>
#include <vector>

#include "common/runner/plot.hpp"
#include "common/runner/thinned.hpp"
#include "common/simulation/simulation.hpp"

namespace clapotis {

/// One instant of a run, for the plots.
struct Sample {
  double time = 0;  ///< [s]
  Energy energy;
  double error = std::numeric_limits<double>::quiet_NaN();
  double max_speed = 0;  ///< [L/s]
};

/// A run's energies and error over time, in bounded memory. Shared by the window and by headless runs.
class History {
 public:
  void add(Simulation& simulation) { add(simulation, simulation.energy()); }
  /// For who has counted the energy already, which costs as much as a step.
  void add(const Simulation& simulation, const Energy& energy);
  void clear() { *this = {}; }
  /// Goes back to an instant of the run, or on to one: what lies behind it is not shown, but stays.
  void show(Simulation& simulation) { latest_ = sample(simulation, simulation.energy()); }
  /// Forgets what lies behind the instant that is shown: the run goes on from there in another way.
  void cut();

  /// The samples kept up to the instant that is shown, and always that one; time grows.
  [[nodiscard]] std::vector<Sample> samples() const;
  [[nodiscard]] const Sample& first() const { return kept_.kept().front(); }
  [[nodiscard]] const Sample& latest() const { return latest_; }
  /// Of all samples that ever came, also those no longer kept; NaN without a reference.
  [[nodiscard]] double largest_error() const { return largest_error_; }
  [[nodiscard]] double largest_speed() const { return largest_speed_; }

 private:
  static Sample sample(const Simulation& simulation, const Energy& energy);

  Thinned<Sample> kept_;
  Sample latest_;
  double largest_error_ = std::numeric_limits<double>::quiet_NaN(), largest_speed_ = 0;
};

// What plots over time are made of.
[[nodiscard]] Curve curve_over_time(const std::vector<Sample>& samples, std::string_view label, Colour colour,
                                    double (*value)(const Sample&));
/// A plot without curves yet; of energies; of errors against a reference, on a logarithmic axis.
[[nodiscard]] Plot plot_over_time(std::string title, std::string y_label);
[[nodiscard]] Plot energies_over_time(const Simulation& simulation);
[[nodiscard]] Plot errors_over_time(const Reference& reference);

/// The energies over time, and beside them the error when the scene has a reference.
std::vector<Plot> plots(const History& history, const Simulation& simulation);

}  // namespace clapotis
