#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

#include "common/laws/surface_tension.hpp"
#include "common/references/capillarity.hpp"
#include "stage5_extensions/scenes.hpp"
#include "tests/catch.hpp"
#include "tests/stage4/state.hpp"

using namespace clapotis;
using namespace clapotis::tests;
using std::numbers::pi;

namespace {

/// Drops of R/dx = 12.5, of which a hundredth of a second takes a fifth.
Simulation drop(Overrides values) {
  values.try_emplace("spacing", Override{"8e-5"});
  return Simulation(stage5::stage().scene("capillary_drop"), values);
}

double sigma_over_radius(const Simulation& s) {
  const double area = static_cast<double>(s.particles().size()) * 8e-5 * 8e-5;
  return laplace_jump(0.072, std::sqrt(area / pi));
}

}  // namespace

TEST_CASE("the pairs of a liquid with surface tension exert the slope of the energy they store",
          "[stage5][capillarity]") {
  Simulation sim = drop({});
  auto parameters = sim.parameters();
  const auto law = SurfaceTension::from(parameters);
  const double rho = 1000, volume = 8e-5 * 8e-5, step = 1e-4 * law.h;
  const WendlandC2 kernel(law.h);
  struct Particle {
    double density;
  } const at_rest{rho};
  double over_plane = 0, most = 0;
  for (double r = 0.05 * law.h; r < 2.1 * law.h; r += 0.05 * law.h) {
    CAPTURE(r / law.h);
    const double slope = (law.pair_energy(r + step) - law.pair_energy(r - step)) / (2 * step);
    const double force =
        volume * volume * law.stress_at(r, at_rest, at_rest) * r * kernel.slope_over_r(r, 1 / r);
    CHECK(-slope == Approx(force).margin(1e-6 * law.pair_energy(0.0) / law.h));  // the difference's own error
    over_plane += law.pair_energy(r) * r;
    most += std::abs(law.pair_energy(r)) * r;
  }
  CHECK(std::abs(over_plane) < 0.01 * most);  // 41 strips of a smooth function
}

TEST_CASE("the tension of a flat surface tends to one value as the lattice becomes fine",
          "[stage5][capillarity]") {
  const double coarse = SurfaceTension::tension_of_flat_surface(3),
               fine = SurfaceTension::tension_of_flat_surface(6);
  CHECK(coarse == Approx(fine).epsilon(0.03));
  CHECK(SurfaceTension::tension_of_flat_surface(4) == Approx(fine).epsilon(0.01));
  // More than the pairs alone give with uniform density, for the pressure of the skin pulls too.
  CHECK(fine > 1.4 * 0.0225);
}

TEST_CASE("a round drop at rest has Laplace's pressure inside, at two resolutions and two tensions",
          "[stage5][capillarity]") {
  const std::string spacing = GENERATE("1e-4", "8e-5"), sigma = GENERATE("0.072", "0.03");
  Simulation calm =
      drop({{"deformation", {"0"}}, {"spacing", {spacing}}, {"sigma", {sigma}}, {"nu", {"5e-5"}}});
  // The mean of a while, for the lattice as it settles shakes the pressure by some per cent.
  double sum = 0;
  int count = 0;
  for (double t = 0.010; t < 0.020; t += 0.0005) {
    run_until(calm, t);
    sum += measure(calm, "pressure_jump");
    ++count;
  }
  CAPTURE(spacing, sigma);
  const double dx = calm.parameters().value("spacing");
  const double radius = std::sqrt(static_cast<double>(calm.particles().size()) / pi) * dx;
  CHECK(sum / count == Approx(calm.parameters().value("sigma") / radius).epsilon(0.1));
  CHECK(max_speed(calm.particles()) < 0.1 * std::sqrt(calm.parameters().value("sigma") / (1000 * radius)));
}

TEST_CASE("a drop that is a little long swings with Rayleigh's period within 5 %", "[stage5][capillarity]") {
  Simulation sim = drop({});
  std::vector<double> zeros;  // of ln(a/b), which passes 0 twice in a period
  double before = std::log(measure(sim, "stretch")), start = 0;
  while (zeros.size() < 3) {
    sim.step();
    const double now = std::log(measure(sim, "stretch"));
    if (before * now < 0) zeros.push_back(start + (sim.time() - start) * before / (before - now));
    before = now;
    start = sim.time();
  }
  const double radius = 0.072 / sigma_over_radius(sim);
  const DropMode exact{.radius = radius, .density = 1000, .sigma = 0.072, .viscosity = 1e-5};
  CHECK(zeros[2] - zeros[0] == Approx(2 * pi / exact.frequency()).epsilon(0.05));
}

TEST_CASE("surface tension moves no drop and turns none", "[stage5][capillarity]") {
  Simulation sim = drop({{"shape", {"square"}}});
  auto& v = sim.system().velocity;
  auto& r = sim.system().position;
  v.col(0) = 0.3 * r.col(1) + 100 * r.col(0).square();  // turns and is torn, without a symmetry
  v.col(1) = -20 * r.col(0) + 0.1;
  sim.system().current = false;
  const auto turning = [](const Particles& p) {
    return p.uniform_mass *
           (p.position.col(0) * p.velocity.col(1) - p.position.col(1) * p.velocity.col(0)).sum();
  };
  const Vector p0 = momentum(sim.particles());
  const double l0 = turning(sim.particles());
  for (int step = 0; step < 200; ++step) sim.step();
  const Vector p1 = momentum(sim.particles());
  // Sums of 460 particles and 100 neighbours each, 200 times, lose some 1e-13 of what is summed.
  const double scale = sim.particles().uniform_mass * static_cast<double>(sim.particles().size()) * 0.1;
  CHECK(norm(p1 - p0) < 1e-11 * scale);
  CHECK(std::abs(turning(sim.particles()) - l0) < 1e-11 * scale * 1e-3);
}

TEST_CASE("a square drop becomes round, and what its surface stored is in the budget of energy",
          "[stage5][capillarity]") {
  Simulation sim = drop({{"shape", {"square"}}, {"nu", {"5e-5"}}});
  const double surface = sim.energy().potential, total = sim.energy().total(),
               corner = measure(sim, "farthest");
  CHECK(corner > 1.2);
  run_until(sim, 0.015);
  CHECK(measure(sim, "farthest") < 1.12);  // half a spacing is 0.04 R
  // Its second moment over that of a disc of the same area, 1.047 for a square.
  const double moment = (sim.particles().position.square().rowwise().sum()).mean() * 2 * pi /
                        (static_cast<double>(sim.particles().size()) * 8e-5 * 8e-5);
  CHECK(moment == Approx(1).margin(0.01));
  CHECK(sim.energy().potential < 0.9 * surface);  // the perimeter is 0.886 of the square's
  // What is lost is the error of the first steps, in which the skin springs into its place.
  CHECK(std::abs(sim.energy().total() - total) < 0.02 * surface);
}

TEST_CASE("a drop on a plate meets it at the contact angle within 8 degrees", "[stage5][capillarity]") {
  const double wanted = GENERATE(60, 90, 120);
  Simulation sim(stage5::stage().scene("sessile_drop"),
                 {{"contact_angle", {to_text(wanted)}}, {"spacing", {"8e-5"}}, {"nu", {"5e-5"}}});
  run_until(sim, 0.02);
  CAPTURE(wanted, measure(sim, "measured_angle"));
  CHECK(measure(sim, "measured_angle") == Approx(wanted).margin(8));  // a spacing is 5 degrees of the rim
}
