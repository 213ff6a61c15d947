#include "common/references/capillarity.hpp"

#include <cmath>
#include <numbers>

#include "common/references/require.hpp"

namespace clapotis {

using std::numbers::pi;

double laplace_jump(double sigma, double radius) {
  Demand{"laplace_jump"}.finite(sigma, "sigma [kg/s^2]");
  Demand{"laplace_jump"}.positive(radius, "radius [m]");
  return sigma / radius;
}

double DropMode::frequency() const {
  const Demand demand{"DropMode"};
  demand.positive(radius, "radius [m]");
  demand.positive(density, "density [kg/m^3]");
  demand.positive(sigma, "sigma [kg/s^2]");
  require(n >= 2, "DropMode", "n", n, ">= 2");
  return std::sqrt(n * (n * n - 1) * sigma / (density * radius * radius * radius));
}

double DropMode::decay() const {
  Demand{"DropMode"}.positive(radius, "radius [m]");
  Demand{"DropMode"}.not_negative(viscosity, "viscosity [m^2/s]");
  return 2 * n * (n - 1) * viscosity / (radius * radius);
}

double DropMode::at(double t) const { return std::exp(-decay() * t) * std::cos(frequency() * t); }

double CircularCap::radius() const {
  Demand{"CircularCap"}.positive(area, "area [m^2]");
  require(angle > 0 && angle < pi, "CircularCap", "angle [rad]", angle, "> 0 and < pi");
  return std::sqrt(area / (angle - std::sin(angle) * std::cos(angle)));
}
double CircularCap::height() const { return radius() * (1 - std::cos(angle)); }
double CircularCap::width() const { return 2 * radius() * std::sin(angle); }
double CircularCap::centre_of_mass() const {
  const double a = radius(), sine = std::sin(angle);
  return 2 * a * a * a * sine * sine * sine / (3 * area) - a * std::cos(angle);
}

double angle_of_cap(double area, double centre_of_mass) {
  double low = 0, high = pi;  // the higher the centre, the greater the angle
  for (int round = 0; round < 48; ++round) {
    const double middle = (low + high) / 2;
    (CircularCap{area, middle}.centre_of_mass() < centre_of_mass ? low : high) = middle;
  }
  return (low + high) / 2;
}

}  // namespace clapotis
