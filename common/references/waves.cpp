#include "common/references/waves.hpp"

#include <cmath>
#include <complex>
#include <numbers>

#include "common/references/require.hpp"

namespace clapotis {

double wave_frequency(double gravity, double k, double depth) {
  Demand{"wave_frequency"}.positive(k, "k [1/m]");
  Demand{"wave_frequency"}.positive(depth, "depth [m]");
  return std::sqrt(gravity * k * std::tanh(k * depth));
}

ViscousWave viscous_wave(double gravity, double k, double viscosity) {
  using Complex = std::complex<double>;
  Demand{"viscous_wave"}.positive(gravity, "gravity [m/s^2]");
  Demand{"viscous_wave"}.positive(k, "k [1/m]");
  Demand{"viscous_wave"}.positive(viscosity, "viscosity [m^2/s]");
  const double damping = 2 * viscosity * k * k;
  const auto equation = [&](Complex n) {
    return (n + damping) * (n + damping) + gravity * k -
           4 * viscosity * viscosity * k * k * k * std::sqrt(k * k + n / viscosity);
  };
  // The secant method, from the wave without viscosity.
  Complex before{0, std::sqrt(gravity * k)}, n{-damping, before.imag()};
  Complex value_before = equation(before);
  for (int round = 0; round < 60 && std::abs(n - before) > 1e-15 * std::abs(n); ++round) {
    const Complex value = equation(n);
    const Complex next = n - value * (n - before) / (value - value_before);
    before = n;
    value_before = value;
    n = next;
  }
  return {.frequency = std::abs(n.imag()), .decay = -n.real()};
}

double SwayedTank::natural_frequency(int n) const {
  return wave_frequency(gravity, n * std::numbers::pi / width, depth);
}

double SwayedTank::elevation(double x, double t) const {
  Demand{"SwayedTank"}.positive(width, "width [m]");
  double sum = 0;
  for (int n = 1; n < 400; n += 2) {
    const double k = n * std::numbers::pi / width, w = natural_frequency(n);
    const double share = 4 * std::tanh(k * depth) / (k * width);
    sum += share * amplitude * omega * omega / (w * w - omega * omega) *
           (std::cos(omega * t) - std::cos(w * t)) * std::cos(k * x);
  }
  return sum;
}

}  // namespace clapotis
