#include <cmath>
#include <string>

#include "tests/catch.hpp"
#include "tests/stage4/brute_force.hpp"
#include "tests/stage4/clouds.hpp"

using namespace clapotis;
using namespace clapotis::tests;

namespace {

/// Where the energy goes at one instant, and the magnitudes of what is summed up for it.
struct Powers {
  double motion = 0;       ///< of all forces but the weight, on the fluid
  double compression = 0;  ///< sum m p/rho^2 d rho/dt, where the density is advanced
  double dissipation = 0;
  double diffusion = 0;
  double scale = 0;
};

Powers powers(Simulation& sim) {
  Powers sum;
  const double g = Liquid::from(sim.parameters()).g, m = sim.parameters().value("particle_mass");
  sim.look([&](const System& s) {
    sum.dissipation = s.dissipation;
    for (Index i = 0; i < s.particles.size(); ++i) {
      const Vector a{s.acceleration(i, 0), s.acceleration(i, 1) + g}, v = row(s.velocity, i);
      sum.motion += m * dot(a, v);
      sum.scale += m * norm(a) * norm(v);
    }
  });
  auto& s = sim.system();
  s.evaluate_density_rate();
  if (!s.advances_density()) return sum;
  const Column power = m * s.particles.pressure / s.density.square() * s.density_rate;
  sum.compression = power.sum();
  sum.scale += power.abs().sum();
  sum.diffusion = s.diffusion;
  return sum;
}

/// Compression, weight, and viscosities of a random cloud, without diffusion of density.
Simulation cloud_in(const std::string& where, Values values) {
  Cloud cloud = random_cloud(1, 21);
  cloud.in_tank = where == "tank";
  if (where == "periodic") cloud.period = {1, 1};
  if (cloud.in_tank) values.emplace_back("tank_width", 1.0);
  return Simulation(scene_of(cloud), typed(values));
}

// Some 1e4 terms, each right to some 1e-15; what fails an identity is a per cent of the sum.
constexpr double round_off = 1e-12;

}  // namespace

TEST_CASE("what the particles lose in motion their compression gains and friction takes, to the last digit",
          "[stage4]") {
  const std::string kernel = GENERATE("cubic_spline", "wendland_c2");
  const std::string where = GENERATE("free", "tank", "periodic");
  const std::string tension = GENERATE("yes", "no");
  const double nu = GENERATE(0.0, 0.3);
  Values values{{"kernel", kernel}, {"h_over_dx", 1.3}, {"tension", tension}, {"alpha", 0.3}, {"delta", 0.0}};
  if (nu > 0) values.insert(values.end(), {{"nu", nu}, {"slip", "no"}});
  auto sim = cloud_in(where, values);
  const auto p = powers(sim);
  CAPTURE(kernel, where, tension, nu, p.motion, p.compression, p.dissipation);
  CHECK(std::abs(p.motion + p.compression + p.dissipation) < round_off * p.scale);
  CHECK(p.diffusion == 0);
  if (where != "tank") CHECK(p.dissipation > 0);
}

TEST_CASE("without friction and walls nothing is lost at all", "[stage4]") {
  const std::string density = GENERATE("continuity", "summation");
  Values values{{"density", density}, {"alpha", 0.0}};
  if (density == "continuity") values.emplace_back("delta", 0.0);
  auto sim = cloud_in("free", values);
  const auto p = powers(sim);
  CHECK(p.dissipation == 0);
  CHECK(p.diffusion == 0);
  CHECK(p.scale > 0);
}

TEST_CASE("the diffusion of density takes the energy out of compression that it says", "[stage4]") {
  const std::string where = GENERATE("free", "tank", "periodic");
  const Values values{{"h_over_dx", 2.0}, {"tension", "yes"}, {"alpha", 0.0}, {"delta", 0.0}};
  auto still = cloud_in(where, values), spreading = cloud_in(where, values);
  spreading.set("delta", "0.1");
  const auto without = powers(still), with = powers(spreading);
  CAPTURE(where);
  CHECK(std::abs(with.compression - without.compression + with.diffusion) < round_off * with.scale);
  // densities of a few per cent to and fro, at random, spread: nothing near round-off
  CHECK(with.diffusion > 1e-3 * with.scale);
}

TEST_CASE("the pressure of a summed density is the slope of its energy", "[stage4]") {
  const std::string kernel = GENERATE("cubic_spline", "wendland_c2");
  const std::string where = GENERATE("free", "tank", "periodic");
  const double nu = GENERATE(0.0, 0.3);
  Values values{
      {"kernel", kernel}, {"density", "summation"}, {"h_over_dx", 2.0}, {"tension", "yes"}, {"alpha", 0.3}};
  if (nu > 0) values.insert(values.end(), {{"nu", nu}, {"slip", "no"}});
  auto sim = cloud_in(where, values);
  const auto p = powers(sim);
  const Vectors here = sim.particles().position;
  const auto energy_after = [&](double t) {
    sim.system().position = here + t * sim.particles().velocity;
    double energy = 0;
    sim.look([&](const System& s) { energy = sim.model().stored_energy(s.particles).internal; });
    return energy;
  };
  // In the time e = 1e-4 h/v a central difference is off by e^2/6 of the third derivative: by (1e-4)^2 times
  // about one, or ten where the energy, a seventh power, is steep. Its round-off over e is less.
  const double e = 1e-5;
  const double rate = (energy_after(e) - energy_after(-e)) / (2 * e);
  CAPTURE(kernel, where, nu, p.motion, rate, p.dissipation);
  CHECK(std::abs(p.motion + rate + p.dissipation) < 1e-7 * p.scale);
  CHECK(std::abs(rate) > 1e-2 * p.scale);
}
