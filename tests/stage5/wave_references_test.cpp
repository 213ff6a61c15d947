#include <cmath>
#include <numbers>
#include <stdexcept>
#include <vector>

#include "common/references/channel_start.hpp"
#include "common/references/waves.hpp"
#include "tests/catch.hpp"

using namespace clapotis;
using std::numbers::pi;

TEST_CASE("flow between plates starts as Morris, Fox & Zhu 1997 computed it", "[references]") {
  const ChannelStart driven{.depth = 1e-3, .viscosity = 1e-6, .force = 1e-4};
  const ChannelStart dragged{.depth = 1e-3, .viscosity = 1e-6, .plate_speed = 1.25e-5};
  struct Reading {
    double t, driven, dragged;
  };
  for (const auto& [t, middle, couette] :
       {Reading{0.0225, 0.17862, 0.01842}, Reading{0.045, 0.33877, 0.09558},
        Reading{0.1125, 0.65999, 0.29028}, Reading{0.225, 0.88798, 0.43090}}) {
    CAPTURE(t);
    CHECK(driven.velocity(5e-4, t) / 1.25e-5 == Approx(middle).margin(5e-6));  // printed digits
    CHECK(dragged.velocity(5e-4, t) / 1.25e-5 == Approx(couette).margin(5e-6));
    CHECK(driven.velocity(0, t) == Approx(0).margin(1e-18));
    CHECK(dragged.velocity(1e-3, t) == Approx(1.25e-5));
  }
  CHECK(driven.velocity(5e-4, 10) == Approx(1.25e-5));  // f d^2/(8 nu)
  CHECK(driven.velocity(5e-4, 0) == 0);
  CHECK_THROWS_AS((ChannelStart{.depth = 0, .viscosity = 1}.velocity(0, 1)), std::invalid_argument);
}

TEST_CASE("a viscous wave swings and decays as Lamb's equation says", "[references]") {
  struct Row {
    double reynolds, frequency, decay;
  };
  // g = 1, lambda = 1, nu = 1/Re, computed with 30 digits.
  for (const auto& [reynolds, frequency, decay] :
       {Row{50, 2.0082119, 0.86560304}, Row{100, 2.3044804, 0.5505483}, Row{250, 2.4523848, 0.2579899},
        Row{500, 2.4871248, 0.1377817}, Row{5000, 2.5060026, 0.015163687}}) {
    CAPTURE(reynolds);
    const auto wave = viscous_wave(1, 2 * pi, 1 / reynolds);
    CHECK(wave.frequency == Approx(frequency).epsilon(1e-7));
    CHECK(wave.decay == Approx(decay).epsilon(1e-6));
  }
  CHECK_THROWS_AS(viscous_wave(1, 1, 0), std::invalid_argument);
}

TEST_CASE("a tank has its natural periods, and answers a sway from rest by them", "[references]") {
  const auto period = [](double width, double depth) {
    return 2 * pi / MovedTank{width, depth, 9.81, 0, 0, 1}.natural_frequency(1);
  };
  CHECK(period(1.73, 0.6) == Approx(1.66779).epsilon(5e-6));
  CHECK(period(0.9, 0.3556) == Approx(1.16749).epsilon(5e-6));
  CHECK(period(1, 0.5) == Approx(1.18182).epsilon(5e-6));

  const MovedTank tank{1, 0.5, 9.81, 0.001, 0, 4.2};
  for (double x = 0; x <= 1; x += 0.125) {
    CAPTURE(x);
    CHECK(tank.elevation(x, 0) == 0);
    CHECK(tank.elevation(x, 0.7) == Approx(-tank.elevation(1 - x, 0.7)).margin(1e-12));
  }
  // At once everything in the tank feels X'' = A W^2, and a liquid that weighs sideways leans: the surface at
  // the left wall begins to rise at the rate that potential flow gives, eta_tt = sum of 4 tanh/(k L) X''.
  const double dt = 1e-4;
  double rate = 0;
  for (int n = 1; n < 400; n += 2) rate += 4 * std::tanh(n * pi * 0.5) / (n * pi) * 0.001 * 4.2 * 4.2;
  CHECK(2 * tank.elevation(0, dt) / (dt * dt) == Approx(rate).epsilon(1e-3));
}

namespace {

/// How the flat surface begins to move when a tank at rest, L = 1 m and H = 0.5 m, is turned about the middle
/// of its floor with theta'' = 1/s^2, by finite differences and without any mode: the potential of the
/// accelerations (Laplace) is 0 on the surface, its slopes on the walls are those of a solid. Returns the
/// share of cos(pi x) in eta''.
double first_share(int n) {
  const double dx = 1.0 / n;
  const int up = n / 2;
  // cells with their centres at (i - 1/2, j - 1/2) dx, and one row or column beyond each side
  std::vector<std::vector<double>> a(static_cast<std::size_t>(n + 2),
                                     std::vector<double>(static_cast<std::size_t>(up + 2), 0.0));
  const auto at = [&](int i, int j) -> double& {
    return a[static_cast<std::size_t>(i)][static_cast<std::size_t>(j)];
  };
  const double relax = 2 / (1 + std::sin(pi / n));
  for (int round = 0; round < 20 * n; ++round) {
    for (int j = 1; j <= up; ++j) {
      const double y = (j - 0.5) * dx;
      at(0, j) = at(1, j) + dx * y;      // -a_x = theta'' y at the left wall
      at(n + 1, j) = at(n, j) - dx * y;  // and at the right one
    }
    for (int i = 1; i <= n; ++i) {
      at(i, 0) = at(i, 1) - dx * ((i - 0.5) * dx - 0.5);  // a_y = theta'' (x - L/2) at the floor
      at(i, up + 1) = -at(i, up);
    }
    for (int i = 1; i <= n; ++i)
      for (int j = 1; j <= up; ++j)
        at(i, j) += relax * ((at(i - 1, j) + at(i + 1, j) + at(i, j - 1) + at(i, j + 1)) / 4 - at(i, j));
  }
  double share = 0;
  for (int i = 1; i <= n; ++i) {
    const double x = (i - 0.5) * dx;
    const double rise = -2 * at(i, up) / dx - (x - 0.5);  // of the water, less that of the tank
    share += 2 * dx * rise * std::cos(pi * x);
  }
  return share;
}

}  // namespace

TEST_CASE("a tank that begins to roll sets its water in motion as potential flow does", "[references]") {
  // eta = theta'' t^2/2 times the share at first; B = theta''/W^2
  const double omega = 4.2, t = 1e-3;
  const MovedTank tank{1, 0.5, 9.81, 0, 1 / (omega * omega), omega};
  double share = 0;
  constexpr int points = 400;
  for (int i = 0; i < points; ++i) {
    const double x = (i + 0.5) / points;
    share += 2.0 / points * tank.elevation(x, t) * std::cos(pi * x) / (t * t / 2);
  }
  const double coarse = first_share(32), fine = first_share(64);
  CHECK(share == Approx(fine + (fine - coarse) / 3).epsilon(1e-3));  // what differences of order 2 tend to
}

TEST_CASE("a tank that is turned slowly has a level surface in the end, and slow sway is a steady push",
          "[references]") {
  // In a thousand natural periods the swing of the modes is of order W/w_1 of the tilt.
  const double omega = 5.3 / 1000, angle = 0.01;
  const MovedTank rolled{1, 0.5, 9.81, 0, angle, omega};
  const double t = pi / omega;  // at its furthest: theta = 2 B
  for (const double x : {0.1, 0.3, 0.8})
    CHECK(rolled.elevation(x, t) == Approx(-2 * angle * (x - 0.5)).margin(1e-3 * angle + angle * 5e-3));
  // At the end of a period the tank has come back, and so has its water.
  CHECK(rolled.elevation(0, 2 * t) == Approx(0).margin(5e-3 * angle));
}

TEST_CASE("a tank moved with its natural period answers with a swing that grows without bound",
          "[references]") {
  MovedTank tank{1, 0.5, 9.81, 0.001, 0, 1};
  tank.omega = tank.natural_frequency(1);
  MovedTank near = tank;
  near.omega *= 1 + 1e-9;
  CHECK(tank.elevation(0, 3.3) == Approx(near.elevation(0, 3.3)).epsilon(1e-6));
  CHECK(tank.greatest(40) > 1.9 * tank.greatest(20));
  CHECK_THROWS_AS((MovedTank{1, 0.5, 9.81, 1, 1, 0}.elevation(0, 1)), std::invalid_argument);
}
