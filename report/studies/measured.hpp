#pragma once

#include <functional>
#include <limits>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "common/simulation/simulation.hpp"

namespace clapotis::studies {

/// The scene that a user would write so for ./lab compare: "stage1/drop:dt=0.01,integrator=rk4".
std::unique_ptr<Simulation> simulation(const std::string& text);

/// That text: scene("stage1/drop", {{"dt", "0.01"}}).
std::string scene(const std::string& name, const std::vector<std::pair<std::string, std::string>>& values);

/// Somebody pressed Ctrl-C: the point that is being measured is given up.
struct Interrupted {};
/// Throws Interrupted when that is so; for loops of long points.
void heed_interrupt();

/// Steps to time `until` exactly; `after` sees each step. Throws Diverged and Interrupted.
void advance(
    Simulation& simulation, double until, const std::function<void(Simulation&)>& after = [](Simulation&) {});
/// The same, so many steps.
void advance_steps(
    Simulation& simulation, long steps, const std::function<void(Simulation&)>& after = [](Simulation&) {});

/// What something took in several runs [s of processor time].
struct Timed {
  double median = std::numeric_limits<double>::quiet_NaN();
  double spread = std::numeric_limits<double>::quiet_NaN();  ///< (largest - smallest)/median
};
Timed timed(int times, const std::function<double()>& seconds_of_one);

/// What a run to `until` costs: processor time of its steps alone, median of `times` runs from new. In the
/// first of them `watch`, if there is one, sees each step, while the clock stands.
struct Cost {
  Timed seconds;
  long steps = 0, evaluations = 0;
};
Cost cost_until(const std::string& text, double until, int times,
                const std::function<void(Simulation&)>& watch = {});

/// Seconds of processor time per step, median of `times` bursts that each take at least `least` [s]. The
/// state moves on meanwhile.
Timed step_cost(Simulation& simulation, int times, double least = 0.05);

/// The straight line y = slope x + at_zero through points, by least squares; NaN for fewer than two.
struct Line {
  double slope = std::numeric_limits<double>::quiet_NaN(), at_zero = slope;
};
Line line_through(const std::vector<double>& x, const std::vector<double>& y);

/// Least squares of log y = exponent log x + log factor, over the pairs of positive finite numbers.
struct PowerLaw {
  double exponent = std::numeric_limits<double>::quiet_NaN(), factor = exponent;
  [[nodiscard]] double at(double x) const;
};
PowerLaw power_law(const std::vector<double>& x, const std::vector<double>& y);

/// The greater of two numbers; NaN when one is missing, so that nothing missing passes for a small error.
double greater(double a, double b);

/// Of pairs (cost, error): those that no other one beats in both, from the cheapest on.
std::vector<std::size_t> pareto_front(const std::vector<double>& costs, const std::vector<double>& errors);

}  // namespace clapotis::studies
