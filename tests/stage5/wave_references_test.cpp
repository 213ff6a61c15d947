#include <cmath>
#include <numbers>
#include <stdexcept>

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
    return 2 * pi / SwayedTank{width, depth, 9.81, 0, 1}.natural_frequency(1);
  };
  CHECK(period(1.73, 0.6) == Approx(1.66779).epsilon(5e-6));
  CHECK(period(0.9, 0.3556) == Approx(1.16749).epsilon(5e-6));
  CHECK(period(1, 0.5) == Approx(1.18182).epsilon(5e-6));

  const SwayedTank tank{1, 0.5, 9.81, 0.001, 4.2};
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
