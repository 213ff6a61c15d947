#pragma once

#include <algorithm>
#include <cmath>
#include <cstring>
#include <initializer_list>
#include <limits>
#include <string>
#include <utility>
#include <variant>
#include <vector>

#include "common/simulation/simulation.hpp"

/// What tests of whole runs share: values as a user types them, runs in so many equal steps, orders of
/// convergence.
namespace clapotis::tests {

inline constexpr double epsilon = std::numeric_limits<double>::epsilon();

/// A number, or a word, given to a parameter.
using Value = std::variant<double, std::string>;
using Values = std::vector<std::pair<std::string, Value>>;

/// The values as a user would give them on the command line.
inline Overrides typed(const Values& values) {
  Overrides overrides;
  for (const auto& [name, value] : values) {
    const auto* number = std::get_if<double>(&value);
    overrides[name] = {number != nullptr ? to_text(*number) : std::get<std::string>(value), Origin::flag};
  }
  return overrides;
}

/// `values`, and dt = until/steps.
inline Overrides typed(Values values, double until, long steps) {
  values.emplace_back("dt", until / static_cast<double>(steps));
  return typed(values);
}

inline void run_to(Simulation& simulation, double until) {
  while (simulation.time() < until) simulation.step(until);
}

inline void run_steps(Simulation& simulation, long steps) {
  for (long step = 0; step < steps; ++step) simulation.step();
}

inline Vector position(const Simulation& simulation, Index i = 0) {
  return row(simulation.particles().position, i);
}
inline Vector velocity(const Simulation& simulation, Index i = 0) {
  return row(simulation.particles().velocity, i);
}

/// Whether two columns hold the same bits; so also where they hold a NaN.
inline bool same_bits(const Vectors& a, const Vectors& b) {
  return a.rows() == b.rows() &&
         std::memcmp(a.data(), b.data(), static_cast<std::size_t>(a.size()) * sizeof(double)) == 0;
}

inline bool same_state(const Simulation& a, const Simulation& b) {
  return same_bits(a.particles().position, b.particles().position) &&
         same_bits(a.particles().velocity, b.particles().velocity) && a.time() == b.time() &&
         a.system().dissipated_energy == b.system().dissipated_energy;
}

/// Slope of log(error) over log(1/steps), by least squares: the order of convergence.
inline double slope(const std::vector<long>& steps, const std::vector<double>& errors) {
  const auto n = static_cast<double>(steps.size());
  double x = 0, y = 0, xx = 0, xy = 0;
  for (std::size_t k = 0; k < steps.size(); ++k) {
    const double a = -std::log(static_cast<double>(steps[k])), b = std::log(errors[k]);
    x += a / n, y += b / n, xx += a * a / n, xy += a * b / n;
  }
  return (xy - x * y) / (xx - x * x);
}

/// One of the schemes, with the order that its theory gives it.
struct Scheme {
  std::string name;
  int order;
};
inline const std::vector<Scheme>& schemes() {
  static const std::vector<Scheme> all{
      {"explicit_euler", 1}, {"symplectic_euler", 1}, {"velocity_verlet", 2}, {"rk2", 2}, {"rk4", 4}};
  return all;
}

}  // namespace clapotis::tests
