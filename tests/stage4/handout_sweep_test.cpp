#include <cmath>
#include <string>

#include "stage4_sph/scenes.hpp"
#include "tests/catch.hpp"
#include "tests/stage4/brute_force.hpp"
#include "tests/stage4/clouds.hpp"

using namespace clapotis;
using namespace clapotis::tests;

TEST_CASE("the handout's liquid obeys its formulas as printed, and as corrected", "[stage4]") {
  const std::string form = GENERATE("printed", "monaghan");
  const std::string signs = GENERATE("printed", "consistent");
  Simulation sim(stage4::stage().scene("handout"),
                 typed({{"viscosity_form", form}, {"signs", signs}, {"radius", 10.0}, {"alpha", 0.7}}));
  const Index n = sim.particles().size();
  const Vectors r = random_points(n, {0, 300, 0, 300}, 1), v = random_points(n, {-99, 99, -99, 99}, 2);
  place(sim, r, v);
  const auto l = Liquid::from(sim.parameters());
  CHECK(l.rho0 == Approx(l.m / (std::numbers::pi * 100)).epsilon(4 * epsilon));  // m/(pi h^2)
  CHECK(l.h == 10);

  // Section VI. Its unit vector: from j to i where the signs are consistent, from i to j as section IV has
  // it.
  const double s = signs == "consistent" ? 1 : -1;
  const auto sums = brute_force(l, r, v, {}, Vectors(0, 2));
  const Column &rho = sums.density.value, &p = sums.pressure.value;
  Sums ax(n), ay(n);
  for (Index i = 0; i < n; ++i) {
    const auto add = [&](double x, double y) {
      ax.value(i) += x;
      ay.value(i) += y;
      ax.scale(i) += std::sqrt(x * x + y * y);
      ay.scale(i) = ax.scale(i);
    };
    add(0, -l.g);
    each_within(l, row(r, i), r, [&](Index j, double dx, double dy, double distance) {
      if (i == j) return;
      const double ux = s * dx / distance, uy = s * dy / distance, slope = l.slope(distance);
      const double pull = -l.m * (p(i) / (rho(i) * rho(i)) + p(j) / (rho(j) * rho(j))) * slope;
      add(pull * ux, pull * uy);
      const double closing = (v(i, 0) - v(j, 0)) * ux + (v(i, 1) - v(j, 1)) * uy;
      if (closing >= 0) return;
      const double mean = (rho(i) + rho(j)) / 2;
      const double mu = l.h * closing * distance / (distance * distance + 0.01 * l.h * l.h);
      const double braked =
          form == "printed" ? l.alpha * l.h * l.c * mean * closing : l.alpha * l.c * mu / mean;
      add(l.m * braked * slope * ux, l.m * braked * slope * uy);
    });
  }
  CAPTURE(form, signs);
  sim.look([&](const System& system) {  // as exact as the sweeps of the other scenes
    CHECK(difference(system.density, sums.density) < 1e-12);
    CHECK(difference(system.particles.pressure, sums.pressure) < 1e-12);
    CHECK(difference(system.acceleration.col(0), ax) < 1e-12);
    CHECK(difference(system.acceleration.col(1), ay) < 1e-12);
  });
}

TEST_CASE("at the handout's spacing every particle is 10/7 as dense as its liquid, even one alone",
          "[stage4]") {
  // the kernel is zero at 2h, so that only W(0) = 10/(7 pi h^2) is left of the sum; rho_0 = m/(pi h^2)
  const double columns = GENERATE(1.0, 5.0);
  Simulation sim(stage4::stage().scene("handout"),
                 typed({{"columns", columns}, {"lines", columns}, {"disturbance", 0.0}}));
  CHECK((sim.particles().density / sim.parameters().value("reference_density") - 10.0 / 7).abs().maxCoeff() <
        8 * epsilon);
  // (10/7)^7 - 1 sevenths of rho_0 c^2
  const double c = sim.sound_speed(), unit = sim.parameters().value("reference_density") * c * c;
  CHECK((sim.particles().pressure / unit).minCoeff() ==
        Approx((std::pow(10.0 / 7, 7) - 1) / 7).epsilon(1e-13));
}
