#pragma once

#include <string_view>
#include <vector>

#include "report/studies/measured.hpp"

/// What the studies of flows share: what a scene measures, what a simulated second costs, and how something
/// that swings is read.
namespace clapotis::studies {

/// What the scene measures under that name, now.
double measure(const Simulation& run, std::string_view name);

/// Processor seconds for a simulated second: of a step, the median of five bursts, times the steps that a
/// second has taken so far. The state moves on meanwhile.
Timed cost_per_second(Simulation& run);

/// Something over time.
struct Series {
  std::vector<double> t, y;
  void add(double time, double value) {
    t.push_back(time);
    y.push_back(value);
  }
};

struct Extreme {
  double t, y;
};
/// The tops and bottoms within a smooth series, each the vertex of the parabola through three instants.
std::vector<Extreme> extremes(const Series& series);
/// When it passes 0, by straight lines between the instants.
std::vector<double> zeros(const Series& series);

/// The frequency w [1/s] within a tenth of `guess` with which c_0 + c_1 cos(w t) + c_2 sin(w t) + c_3 cos(W
/// t) comes nearest to the series, in the sense of least squares: a swing that is driven with W = `driven`.
double free_frequency(const Series& series, double guess, double driven);

}  // namespace clapotis::studies
