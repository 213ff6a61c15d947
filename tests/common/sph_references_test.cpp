#include <array>
#include <cmath>
#include <limits>
#include <numbers>
#include <stdexcept>
#include <string>
#include <vector>

#include "common/references/dam_break_front.hpp"
#include "common/references/elliptical_drop.hpp"
#include "common/references/hydrostatic.hpp"
#include "common/references/square_patch.hpp"
#include "common/references/stability_limits.hpp"
#include "tests/catch.hpp"

using namespace clapotis;

namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();
constexpr double not_a_number = std::numeric_limits<double>::quiet_NaN();
constexpr double round_off = std::numeric_limits<double>::epsilon();
constexpr double pi = std::numbers::pi;

/// A tank one metre deep whose water carries sound at the speed that SPH gives it, c^2 = 200 g H.
HydrostaticColumn tank_of_sph(double gamma) { return {1000, std::sqrt(200 * 9.81), gamma, 9.81}; }

EllipticalDrop unit_drop() { return {1, 1, 1}; }
EllipticalDrop water_drop() { return {0.02, 50, 1000}; }

/// Energy of a uniform strain A in an ellipse: rho/2 A^2 times the integral of x^2 + y^2, pi a b (a^2 +
/// b^2)/4.
double energy_of_strain(double density, double strain_rate, double a, double b) {
  return density / 8 * pi * a * b * (a * a + b * b) * strain_rate * strain_rate;
}

struct Strained {
  double strain_rate, semi_axis_x;
  friend Strained operator+(const Strained& p, const Strained& q) {
    return {p.strain_rate + q.strain_rate, p.semi_axis_x + q.semi_axis_x};
  }
  friend Strained operator*(double s, const Strained& p) { return {s * p.strain_rate, s * p.semi_axis_x}; }
};

/// Monaghan's equations of the unit drop, as printed, and their solution by Runge-Kutta 4.
Strained monaghan_rate(const Strained& s) {
  const double fourth = std::pow(s.semi_axis_x, 4);
  return {s.strain_rate * s.strain_rate * (fourth - 1) / (fourth + 1), -s.semi_axis_x * s.strain_rate};
}

Strained monaghan_drop(double t, int steps) {
  Strained s{1, 1};
  const double dt = t / steps;
  for (int n = 0; n < steps; ++n) {
    const Strained k1 = monaghan_rate(s), k2 = monaghan_rate(s + dt / 2 * k1);
    const Strained k3 = monaghan_rate(s + dt / 2 * k2), k4 = monaghan_rate(s + dt * k3);
    s = s + dt / 6 * (k1 + 2 * k2 + 2 * k3 + k4);
  }
  return s;
}

/// The double series of Colagrossi 2005 for the square patch, over rho omega^2 L^2, odd modes below `modes`.
double patch_by_double_series(double x, double y, int modes) {
  double sum = 0;
  for (int m = 1; m < modes; m += 2) {
    for (int n = 1; n < modes; n += 2) {
      const double curvature = pi * pi * (m * m + n * n);
      sum -= 32 / (m * n * pi * pi * curvature) * std::sin(m * pi * (x + 0.5)) * std::sin(n * pi * (y + 0.5));
    }
  }
  return sum;
}

}  // namespace

TEST_CASE("in still water the pressure carries the weight above it and squeezes it by Cole's equation",
          "[references]") {
  const double gamma = GENERATE(1.0, 1.0000001, 1.4, 7.0);
  const double sound_speed = GENERATE(3.0, 44.0, 1500.0);
  const HydrostaticColumn water{1000, sound_speed, gamma, 9.81};
  // Central differences: dz^2/6 p''' is at most 4e-7 of rho g (c = 3 m/s, gamma = 7); round-off is 1e-9 of
  // it.
  const double dz = 1e-3;
  for (double z = 0.1; z < 1.05; z += 0.1) {
    const double rho = water.density(z);
    const double slope = (water.pressure(z + dz) - water.pressure(z - dz)) / (2 * dz);
    const double cole = 1000 * sound_speed * sound_speed / gamma * (std::pow(rho / 1000, gamma) - 1);
    CAPTURE(gamma, sound_speed, z);
    CHECK(slope == Approx(rho * 9.81).epsilon(5e-7));
    // Cole's difference of powers keeps no more than round-off times rho0 c^2.
    CHECK(std::abs(water.pressure(z) - cole) < 4 * round_off * 1000 * sound_speed * sound_speed);
  }
}

TEST_CASE("the bottom of a tank of SPH water bears a quarter of a per cent more than rho g H",
          "[references]") {
  // p/(rho g H) for zeta = g H/c^2 = 1/200, computed with 30 digits. The tank's c^2 is off by round-off.
  CHECK(tank_of_sph(7).pressure(1) / 9810 == Approx(1.00247944834665394).epsilon(8 * round_off));
  CHECK(tank_of_sph(1).pressure(1) / 9810 == Approx(1.00250417188021268).epsilon(8 * round_off));
  CHECK(tank_of_sph(1.000001).pressure(1) / 9810 == Approx(1.00250417187603035).epsilon(8 * round_off));
  CHECK(tank_of_sph(7).density(1) == Approx(1000 * std::pow(1.03, 1.0 / 6)).epsilon(8 * round_off));
  // Deep down: zeta = 1/2, where water of gamma = 7 has grown a quarter denser.
  CHECK(HydrostaticColumn{1, 1, 7, 1}.pressure(0.5) == Approx(0.57709774279707038).epsilon(8 * round_off));
  CHECK(HydrostaticColumn{1, 1, 7, 1}.density(0.5) == Approx(std::pow(4, 1.0 / 6)).epsilon(8 * round_off));
}

TEST_CASE("water that sound crosses at once bears rho g z, without losing a digit", "[references]") {
  const HydrostaticColumn stiff{1000, 1e9, GENERATE(1.0, 7.0), 9.81};
  CHECK(stiff.pressure(3) == Approx(29430).epsilon(8 * round_off));
  CHECK(stiff.density(3) == 1000);
  CHECK(HydrostaticColumn{1000, 44, 7, 0}.pressure(3) == 0);  // weightless
}

TEST_CASE("above still water there is nothing to press", "[references]") {
  CHECK(tank_of_sph(7).pressure(0) == 0);
  CHECK(tank_of_sph(7).pressure(-0.3) == 0);
  CHECK(tank_of_sph(7).density(-0.3) == 1000);
}

TEST_CASE("still water out of the physical range is refused", "[references]") {
  CHECK_THROWS_AS((HydrostaticColumn{0, 44, 7, 9.81}.pressure(1)), std::invalid_argument);
  CHECK_THROWS_AS((HydrostaticColumn{1000, -44, 7, 9.81}.density(1)), std::invalid_argument);
  CHECK_THROWS_AS((HydrostaticColumn{1000, infinity, 7, 9.81}.pressure(1)), std::invalid_argument);
  CHECK_THROWS_AS((HydrostaticColumn{1000, 44, 7, -9.81}.pressure(1)), std::invalid_argument);
  CHECK_THROWS_AS(tank_of_sph(not_a_number).pressure(1), std::invalid_argument);
  CHECK_THROWS_AS(tank_of_sph(7).pressure(not_a_number), std::invalid_argument);
  CHECK_THROWS_WITH(tank_of_sph(0.5).pressure(1),
                    "HydrostaticColumn: gamma is 0.5, it must be finite and >= 1");
}

TEST_CASE(
    "a free drop stretches, and its pressure falls, as Monaghan's equations integrated with RK4 have it",
    "[references]") {
  // t A0, A/A0, a/R, b/R, p0/(rho A0^2 R^2); eight printed decimals.
  const std::vector<std::array<double, 5>> table{
      {0.2, 0.96270219, 0.82082616, 1.21828476, 0.42947496},
      {0.4, 0.87510122, 0.68269926, 1.46477382, 0.29322647},
      {0.6, 0.77616054, 0.57880935, 1.72768459, 0.18145805},
      {0.76, 0.70310892, 0.51426647, 1.94451719, 0.12219697},
      {1, 0.61021577, 0.43946077, 2.27551598, 0.06932721},
      {2, 0.38335826, 0.27181408, 3.67898532, 0.01079914},
  };
  const EllipticalDrop drop = water_drop();
  for (const auto& [time, strain_rate, a, b, pressure] : table) {
    const EllipticalDrop::State state = drop.at(time / drop.strain_rate);
    CAPTURE(time);
    CHECK(std::abs(state.strain_rate / drop.strain_rate - strain_rate) <= 5.01e-9);
    CHECK(std::abs(state.semi_axis_x / drop.radius - a) <= 5.01e-9);
    CHECK(std::abs(state.semi_axis_y / drop.radius - b) <= 5.01e-9);
    CHECK(std::abs(state.centre_pressure / 1000 - pressure) <= 5.01e-9);  // rho A0^2 R^2 = 1000 Pa
  }
}

TEST_CASE("a free drop follows its elliptic integral to the last digits, at early and at late times",
          "[references]") {
  // t A0, A/A0, b/R, computed with 30 digits.
  const auto passes = [](double time, double strain_rate, double stretch) {
    const EllipticalDrop::State state = unit_drop().at(time);
    CAPTURE(time);
    CHECK(state.strain_rate == Approx(strain_rate).epsilon(8 * round_off));
    CHECK(state.semi_axis_y == Approx(stretch).epsilon(8 * round_off));
    CHECK(state.semi_axis_x == Approx(1 / stretch).epsilon(8 * round_off));
    CHECK(state.centre_pressure == Approx(std::pow(strain_rate, 4) / 2).epsilon(32 * round_off));
  };
  passes(0.1, 0.990179477955339552, 1.10480657895451461);
  passes(0.76, 0.703108922271935903, 1.94451719071561569);
  passes(2, 0.383358262717715218, 3.67898532373853709);
  passes(10, 0.0943466533472755819, 14.9893981959933115);
  passes(1000, 0.000999401288552602998, 1415.06077545794785);
  // Late, b grows as sqrt(2) A0 t: all energy has become motion along y, v = A0 sqrt(2) R at the tip.
  CHECK(unit_drop().at(1e100).semi_axis_y == Approx(std::numbers::sqrt2 * 1e100).epsilon(1e-13));
}

TEST_CASE("a free drop obeys Monaghan's equations", "[references]") {
  const double time = GENERATE(0.05, 0.3, 0.76, 1.5, 2.0);
  const Strained integrated = monaghan_drop(time, 4000);  // (dt = 5e-4)^4 = 6e-14, and round-off 4,000 times
  const EllipticalDrop::State exact = unit_drop().at(time);
  CHECK(std::abs(exact.strain_rate - integrated.strain_rate) < 1e-12);
  CHECK(std::abs(exact.semi_axis_x - integrated.semi_axis_x) < 1e-12);
  CHECK(exact.semi_axis_x * exact.semi_axis_y == Approx(1).epsilon(4 * round_off));
}

TEST_CASE("every particle of a free drop is accelerated by the pressure, which ends at the rim",
          "[references]") {
  const EllipticalDrop drop = water_drop();
  const double time = GENERATE(0.0, 0.1, 0.5, 1.0, 2.0) / drop.strain_rate;
  const EllipticalDrop::State now = drop.at(time);
  const double a = now.semi_axis_x, b = now.semi_axis_y;
  // Central differences: 1e-4 of the time scale leaves 1e-8, and round-off 1e-12.
  const double dt = 1e-4 / drop.strain_rate;
  const EllipticalDrop::State before = drop.at(time - dt), after = drop.at(time + dt);
  const double growth = (after.semi_axis_y - before.semi_axis_y) / (2 * dt);
  const double strain_growth = (after.strain_rate - before.strain_rate) / (2 * dt);
  CHECK(growth == Approx(now.strain_rate * b).epsilon(1e-7));
  const double x = 0.4 * a, y = -0.3 * b, dx = 1e-3 * a, dy = 1e-3 * b;  // p is quadratic: no error from dx
  const double slope_x = (now.pressure(x + dx, y) - now.pressure(x - dx, y)) / (2 * dx);
  const double slope_y = (now.pressure(x, y + dy) - now.pressure(x, y - dy)) / (2 * dy);
  // u = -A x, v = A y: Du/Dt = (A^2 - A') x, Dv/Dt = (A^2 + A') y, over the scale A0^2 R.
  const double square = now.strain_rate * now.strain_rate;
  const double scale = drop.strain_rate * drop.strain_rate * drop.radius;
  CHECK(std::abs((square - strain_growth) * x + slope_x / drop.density) < 1e-7 * scale);
  CHECK(std::abs((square + strain_growth) * y + slope_y / drop.density) < 1e-7 * scale);
  CHECK(std::abs(now.pressure(0.6 * a, 0.8 * b)) < 4 * round_off * now.centre_pressure);
  CHECK(now.pressure(1.1 * a, 0) == 0);
  CHECK(now.pressure(0, 0) == now.centre_pressure);
}

TEST_CASE("a free drop keeps the energy of its motion, whatever its shape", "[references]") {
  const EllipticalDrop drop = water_drop();
  CHECK(drop.kinetic_energy() == Approx(pi / 4 * 1000 * std::pow(0.02, 4) * 2500).epsilon(8 * round_off));
  const double dt = 1e-4 / drop.strain_rate;
  for (double time = 0; time < 5 / drop.strain_rate; time += 0.1 / drop.strain_rate) {
    const EllipticalDrop::State now = drop.at(time);
    CAPTURE(time);
    CHECK(energy_of_strain(drop.density, now.strain_rate, now.semi_axis_x, now.semi_axis_y) ==
          Approx(drop.kinetic_energy()).epsilon(16 * round_off));
    // The strain as the shape tells it, d ln b/dt, by central differences: (A0 dt)^2 = 1e-8.
    const double seen = std::log(drop.at(time + dt).semi_axis_y / drop.at(time - dt).semi_axis_y) / (2 * dt);
    CHECK(energy_of_strain(drop.density, seen, now.semi_axis_x, now.semi_axis_y) ==
          Approx(drop.kinetic_energy()).epsilon(1e-7));
  }
}

TEST_CASE("a free drop is a disc at the start, and was as long along x as it will be along y",
          "[references]") {
  const EllipticalDrop drop = water_drop();
  const EllipticalDrop::State start = drop.at(0);
  CHECK(start.semi_axis_x == drop.radius);
  CHECK(start.semi_axis_y == drop.radius);
  CHECK(start.strain_rate == Approx(50).epsilon(2 * round_off));
  // p = rho A0^2 (R^2 - r^2)/2
  CHECK(start.pressure(0.01, 0.005) == Approx(1000 * 2500 * (4e-4 - 1.25e-4) / 2).epsilon(8 * round_off));
  CHECK(drop.at(-0.03).semi_axis_x == Approx(drop.at(0.03).semi_axis_y).epsilon(4 * round_off));
  CHECK(drop.at(-0.03).strain_rate == Approx(drop.at(0.03).strain_rate).epsilon(4 * round_off));
}

TEST_CASE("a drop out of the physical range is refused", "[references]") {
  CHECK_THROWS_AS((EllipticalDrop{0, 1, 1}.at(0)), std::invalid_argument);
  CHECK_THROWS_AS((EllipticalDrop{1, not_a_number, 1}.at(0)), std::invalid_argument);
  CHECK_THROWS_AS((EllipticalDrop{1, 1, infinity}.kinetic_energy()), std::invalid_argument);
  CHECK_THROWS_AS(unit_drop().at(infinity), std::invalid_argument);
  CHECK_THROWS_WITH((EllipticalDrop{1, -2, 1}.at(0)),
                    "EllipticalDrop: strain_rate [1/s] is -2, it must be finite and > 0");
}

TEST_CASE("the front of a dam break is where the experiment saw it, and in between on a straight line",
          "[references]") {
  CHECK(koshizuka_oka_1996.front(0) == 1);  // the column before it falls
  CHECK(koshizuka_oka_1996.front(3.096) == 3.624);
  CHECK(koshizuka_oka_1996.front(1.345) == Approx((1.505 + 1.892) / 2));
  CHECK(martin_moyce_1952_small.front(2.283) == 2.689);
  CHECK(martin_moyce_1952_large.front(4.034) == 4.944);
  for (const FrontExperiment& experiment : dam_break_fronts) {
    CAPTURE(std::string(experiment.name));
    for (const auto& [time, front] : experiment.readings) CHECK(experiment.front(time) == front);
    CHECK(std::isnan(experiment.front(experiment.readings.front().time - 1e-9)));
    CHECK(std::isnan(experiment.front(experiment.readings.back().time + 1e-9)));
    CHECK(std::isnan(experiment.front(not_a_number)));
    CHECK(std::isnan(FrontExperiment{"", "", {}}.front(1)));
  }
}

TEST_CASE("the front of a dam break only advances, and not faster than shallow water on a dry bed",
          "[references]") {
  // Ritter 1892: 2 sqrt(g 2a), which is dZ/dT = 2. Readings are right to 2 % in T and in Z.
  for (const FrontExperiment& experiment : dam_break_fronts) {
    for (std::size_t n = 1; n < experiment.readings.size(); ++n) {
      const FrontReading from = experiment.readings[n - 1], to = experiment.readings[n];
      CAPTURE(std::string(experiment.name), to.time);
      CHECK(to.time > from.time);
      CHECK(to.front > from.front);
      CHECK(to.front - from.front < 2 * (to.time - from.time + 0.02 * to.time) + 0.02 * to.front);
    }
  }
}

TEST_CASE("columns of 3, 6 and 15 cm collapse alike", "[references]") {
  for (double time = 0.85; time < 5.3; time += 0.05) {
    for (const FrontExperiment& one : dam_break_fronts) {
      for (const FrontExperiment& other : dam_break_fronts) {
        if (std::isnan(one.front(time)) || std::isnan(other.front(time))) continue;
        CAPTURE(std::string(one.name), std::string(other.name), time);
        CHECK(one.front(time) == Approx(other.front(time)).epsilon(0.12));  // the scatter, at T = 2.7
      }
    }
  }
}

TEST_CASE("the pressure in a turning square patch is lowest in its centre, by the published amount",
          "[references]") {
  const SquarePatch patch{1, 1, 1};
  CHECK(std::abs(patch.pressure(0, 0) + 0.14734) < 5e-6);  // printed digits
  // Computed with 30 digits.
  CHECK(patch.pressure(0, 0) == Approx(-0.147342706563027631).epsilon(16 * round_off));
  CHECK(patch.pressure(0.25, 0) == Approx(-0.114669812949216667).epsilon(16 * round_off));
  CHECK(patch.pressure(-0.25, 0.25) == Approx(-0.0905723162189454115).epsilon(16 * round_off));
  CHECK(patch.pressure(0.2, -0.4) == Approx(-0.0512559578376477367).epsilon(16 * round_off));
  const SquarePatch basin{3, -2, 1000};  // rho omega^2 L^2 = 36,000 Pa, in either sense of turning
  CHECK(basin.pressure(-0.3, 0.9) == Approx(36000 * -0.0963111446373773421).epsilon(16 * round_off));
}

TEST_CASE("the pressure in a turning square patch is the double series in the literature", "[references]") {
  const SquarePatch patch{1, 1, 1};
  for (double x = -0.45; x < 0.5; x += 0.15) {
    for (double y = -0.45; y < 0.5; y += 0.15) {
      CAPTURE(x, y);
      // The modes left out have changing signs and cancel but for about the first row of them: 32/pi^4 times
      // the sum over n of 1/(n M (M^2 + n^2)), which is 1.3e-7 for M = 200, from each of the two directions.
      CHECK(std::abs(patch.pressure(x, y) - patch_by_double_series(x, y, 200)) < 2.6e-7);
    }
  }
}

TEST_CASE("the pressure in a turning square patch balances the centrifugal force, and ends at the rim",
          "[references]") {
  const SquarePatch patch{1, 1, 1};
  const double d =
      1e-3;  // d^2/12 of fourth derivatives, which grow towards the corners to 500: 4e-5; round-off 1e-9
  for (double x = -0.45; x < 0.5; x += 0.09) {
    for (double y = -0.45; y < 0.5; y += 0.09) {
      const double around = patch.pressure(x + d, y) + patch.pressure(x - d, y) + patch.pressure(x, y + d) +
                            patch.pressure(x, y - d);
      CAPTURE(x, y);
      CHECK((around - 4 * patch.pressure(x, y)) / (d * d) == Approx(2).margin(5e-5));
      CHECK(patch.pressure(y, -x) == Approx(patch.pressure(x, y)).epsilon(8 * round_off));
    }
  }
  for (double along = -0.5; along <= 0.5; along += 0.05) {
    CHECK(patch.pressure(0.5, along) == 0);
    CHECK(patch.pressure(along, -0.5) == 0);
    // Where the series converges worst: next to the rim p is still small and negative.
    CHECK(patch.pressure(along, 0.5 - 1e-9) <= 0);
    CHECK(patch.pressure(along, 0.5 - 1e-9) > -1e-9);
  }
  CHECK(patch.pressure(0.5 - 1e-5, 0.5 - 1e-5) < 0);  // the very corner
  CHECK(patch.pressure(0.5 - 1e-5, 0.5 - 1e-5) > -1e-8);
  CHECK(patch.pressure(0.7, 0) == 0);
}

TEST_CASE("a turning patch out of the physical range is refused", "[references]") {
  CHECK_THROWS_AS((SquarePatch{0, 1, 1}.pressure(0, 0)), std::invalid_argument);
  CHECK_THROWS_AS((SquarePatch{1, infinity, 1}.pressure(0, 0)), std::invalid_argument);
  CHECK_THROWS_AS((SquarePatch{1, 1, 1}.pressure(0, not_a_number)), std::invalid_argument);
  CHECK_THROWS_WITH((SquarePatch{1, 1, 0}.pressure(0, 0)),
                    "SquarePatch: density [kg/m^3] is 0, it must be finite and > 0");
}

TEST_CASE("symplectic Euler and RK4 meet their limits on one and the same fastest wave of the lattice",
          "[references]") {
  const SphStabilityLimits& undamped = sph_stability_limits.front();
  REQUIRE(undamped.alpha == 0);
  const StabilityLimits& measured = undamped.dt_c_over_h;
  // w h/c = 1.06, 1.07: the steps that were tried lie 1.5 % apart.
  CHECK(oscillator_limits.symplectic_euler / measured.symplectic_euler ==
        Approx(oscillator_limits.rk4 / measured.rk4).epsilon(0.015));
  // The amplification of RK4, 1 - w^2/2 + w^4/24 + i (w - w^3/6), leaves the unit circle at its limit.
  const auto amplification = [](double w) {
    return std::hypot(1 - w * w / 2 + w * w * w * w / 24, w - w * w * w / 6);
  };
  CHECK(amplification(oscillator_limits.rk4) == Approx(1).epsilon(8 * round_off));
  CHECK(amplification(oscillator_limits.rk4 * 1.001) > 1);
  CHECK(amplification(oscillator_limits.rk4 * 0.999) < 1);
}

TEST_CASE("artificial viscosity steadies explicit Euler and RK2 and slows the others down", "[references]") {
  const StabilityLimits none = sph_stability_limits[0].dt_c_over_h,
                        some = sph_stability_limits[1].dt_c_over_h,
                        strong = sph_stability_limits[2].dt_c_over_h;
  CHECK(none.explicit_euler < some.explicit_euler);
  CHECK(some.explicit_euler < strong.explicit_euler);
  CHECK(none.rk2 < some.rk2);
  CHECK(some.rk2 < strong.rk2);
  CHECK(strong.symplectic_euler < some.symplectic_euler);
  CHECK(some.symplectic_euler < none.symplectic_euler);
}
