#include "common/references/waves.hpp"

#include <algorithm>
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

double MovedTank::natural_frequency(int n) const {
  return wave_frequency(gravity, n * std::numbers::pi / width, depth);
}

double MovedTank::elevation(double x, double t) const {
  Demand{"MovedTank"}.positive(width, "width [m]");
  Demand{"MovedTank"}.positive(omega, "omega [1/s]");
  double sum = 0;
  for (int n = 1; n < 400; n += 2) {
    const double k = n * std::numbers::pi / width, w = natural_frequency(n), tanh = std::tanh(k * depth);
    const double arm = depth - 2 / k * std::tanh(k * depth / 2);
    // b'' + w^2 b = constant + swinging cos W t, from rest; (cos W t - cos w t)/(w^2 - W^2) without a hole at
    // W = w
    const double constant = gravity * angle;
    const double swinging = amplitude * omega * omega - angle * (gravity + omega * omega * arm);
    const double half = (w - omega) * t / 2, slow = half == 0 ? 1 : std::sin(half) / half;
    const double b = constant / (w * w) * (1 - std::cos(w * t)) +
                     swinging * t * slow * std::sin((w + omega) * t / 2) / (w + omega);
    sum += 4 * tanh / (k * width) * b * std::cos(k * x);
  }
  return sum;
}

double MovedTank::greatest(double t) const {
  double most = 0;
  for (int k = 1; k <= 300; ++k) most = std::max(most, std::abs(elevation(0, t * k / 300)));
  return most;
}

}  // namespace clapotis
