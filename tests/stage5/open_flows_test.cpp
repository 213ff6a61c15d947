#include <cmath>
#include <complex>
#include <numbers>

#include "common/measures/energy.hpp"
#include "common/references/draining_tank.hpp"
#include "common/references/film_flow.hpp"
#include "common/references/impinging_jet.hpp"
#include "stage5_extensions/scenes.hpp"
#include "tests/catch.hpp"
#include "tests/stage4/state.hpp"

using namespace clapotis;
using namespace clapotis::tests;

namespace {

const Overrides coarse_jet{{"spacing", {"0.01"}}};

/// Particles at the start and those that entered, less those that left and those that are there: none may be
/// missing.
long missing(const Simulation& flow, Index at_start) {
  const auto& s = flow.system();
  return static_cast<long>(at_start) + s.entered - s.left - static_cast<long>(s.particles.size());
}

}  // namespace

TEST_CASE("a jet presses on a plate with rho U^2 d, within 5 %, by the profile of free streamlines",
          "[stage5]") {
  Simulation jet(stage5::stage().scene("jet"), coarse_jet);
  const Index at_start = jet.particles().size();
  run_until(jet, 1);
  // Sound runs to and fro between plate and surfaces, a few per cent of the force: the mean of two widths'
  // time.
  double force = 0, middle = 0, beside = 0, count = 0;
  const auto pressure_at = [&](double x) {
    const auto& walls = *jet.model().wall_particles();
    double sum = 0, near = 0;
    for (Index k = 0; k < walls.size(); ++k)
      if (walls.places(k, 1) > -0.01 && std::abs(std::abs(walls.places(k, 0)) - x) < 0.011) {
        sum += walls.columns.pressure(k);
        ++near;
      }
    return sum / near;
  };
  while (jet.time() < 1.4) {
    jet.step();
    force += measure(jet, "plate_force");
    middle += pressure_at(0);
    beside += pressure_at(0.1);
    ++count;
  }
  const ImpingingJet exact{0.1, 1, 1000};
  CHECK(force / count == Approx(exact.force()).epsilon(0.05));
  CHECK(middle / count == Approx(exact.pressure(0)).epsilon(0.1));
  CHECK(beside / count == Approx(exact.pressure(0.1)).epsilon(0.1));
  CHECK(missing(jet, at_start) == 0);
  CHECK(jet.system().entered > 500);
}

TEST_CASE("of a continuous flow nothing gets lost, and as much goes out as comes in", "[stage5]") {
  Simulation flow(stage5::stage().scene("channel"), {{"spacing", {"1e-3"}}});
  const Index at_start = flow.particles().size();
  run_until(flow, 1);
  CHECK(missing(flow, at_start) == 0);
  CHECK(flow.system().entered > 300);
  CHECK(std::abs(static_cast<double>(flow.particles().size() - at_start)) <
        0.02 * static_cast<double>(at_start));
  // a film keeps the profile that it came in with
  CHECK(flow.error() < 0.02);
  CHECK(measure(flow, "flow_rate") == Approx(2.0 / 3 * 0.01 * 0.1).epsilon(0.02));
}

TEST_CASE("what comes in and goes out is in the budget of energy", "[stage5]") {
  const auto [scene, until, tolerance] = GENERATE(table<std::string, double, double>(
      {{"jet", 0.6, 0.01}, {"channel", 0.3, 0.002}, {"draining", 0.3, 0.005}}));
  CAPTURE(scene);
  const Overrides coarse{{"spacing", {scene == "channel" ? "1e-3" : scene == "jet" ? "0.01" : "0.02"}}};
  Simulation flow(stage5::stage().scene(scene), coarse);
  const double start = flow.energy().total();
  run_until(flow, until);
  CHECK(flow.system().left > 0);
  CHECK(flow.energy().total() == Approx(start).epsilon(tolerance));
}

TEST_CASE("a tank drains as Torricelli says, within 5 % of its level", "[stage5]") {
  Simulation tank(stage5::stage().scene("draining"), {{"spacing", {"0.02"}}});
  run_until(tank, 0.8);
  const DrainingTank exact{1, 0.1, 0.6, 9.81};
  CHECK(measure(tank, "level") == Approx(exact.level(0.8)).epsilon(0.05));
}

TEST_CASE("a continuous flow is the same with any number of threads", "[stage5]") {
  Simulation one(stage5::stage().scene("jet"), coarse_jet),
      two(stage5::stage().scene("jet"), coarse_jet, default_integrator, 2);
  for (int k = 0; k < 60; ++k) {
    one.step();
    two.step();
  }
  CHECK(one.system().entered > 0);
  CHECK(same_fluid(one, two));
}

TEST_CASE("a particle that has left takes its id with it", "[particles]") {
  Particles p(4, 1);
  p.density = p.pressure = Column::Zero(4);
  for (Index i = 0; i < 4; ++i) p.position(i, 0) = static_cast<double>(i);
  p.keep({1, 0, 1, 0});
  REQUIRE(p.size() == 2);
  CHECK(p.id(1) == 2);
  CHECK(p.position(1, 0) == 2);
  CHECK_FALSE(p.place_of(3));
  const Index born = p.append(2);
  CHECK(p.id(born) == 4);
  CHECK(p.place_of(5) == 3);
  CHECK(p.density.size() == 4);
  CHECK(p.density_rate.size() == 0);
  p.keep({0, 0, 0, 0});
  CHECK(p.columns().size() == 2);
  CHECK(p.density.size() == 0);
  CHECK(p.append(1) == 0);
  CHECK(p.id(0) == 6);
  CHECK(p.density.size() == 1);
}

TEST_CASE("a slot as wide as its tank, and a jet wider than its plate, are refused", "[stage5]") {
  CHECK_THROWS_WITH(
      Simulation(stage5::stage().scene("draining"), {{"slot_width", {"1.5"}}}),
      Catch::Matchers::ContainsSubstring("slot_width") && Catch::Matchers::ContainsSubstring("1.5"));
  CHECK_THROWS_WITH(
      Simulation(stage5::stage().scene("jet"), {{"jet_width", {"0.7"}}}),
      Catch::Matchers::ContainsSubstring("jet_width") && Catch::Matchers::ContainsSubstring("0.7"));
}

TEST_CASE("a jet, a film and a draining tank have their closed forms", "[references]") {
  const ImpingingJet jet{0.1, 2, 1000};
  CHECK(jet.force() == Approx(400));
  CHECK(jet.pressure(0) == Approx(2000));
  CHECK(jet.pressure(-0.05) == Approx(jet.pressure(0.05)));
  double sum = 0;  // the force is the integral of the pressure
  for (double x = -1; x < 1; x += 1e-3) sum += jet.pressure(x + 5e-4) * 1e-3;
  CHECK(sum == Approx(jet.force()).epsilon(1e-4));
  // s = 1/2 at x/d = (2/pi)(atan 1/2 + artanh 1/2)
  CHECK(jet.pressure(0.1 * 2 / M_PI * (std::atan(0.5) + std::atanh(0.5))) == Approx(1500));
  CHECK_THROWS_AS((ImpingingJet{0, 1, 1}.pressure(0)), std::invalid_argument);

  const FilmFlow film{0.01, 5e-4, 1};
  CHECK(film.velocity(0) == 0);
  CHECK(film.velocity(0.01) == Approx(0.1));
  CHECK_THROWS_AS((FilmFlow{0.01, 0, 1}.velocity(0)), std::invalid_argument);

  const DrainingTank tank{1, 0.1, 0.6, 9.81};
  CHECK(tank.level(0) == Approx(0.6));
  // dh/dt = -C_c (b/W) sqrt(2 g h)
  CHECK((tank.level(1.001) - tank.level(0.999)) / 0.002 ==
        Approx(-M_PI / (M_PI + 2) * 0.1 * std::sqrt(2 * 9.81 * tank.level(1))).epsilon(1e-6));
  CHECK(tank.level(100) == 0);
  CHECK_THROWS_AS((DrainingTank{1, 2, 1, 1}.level(0)), std::invalid_argument);
}

TEST_CASE("the surface of a jet on a plate is that of free-streamline theory, the same with x and y exchanged",
          "[stage5]") {
  const ImpingingJet jet{0.1, 2, 1000};
  for (const double theta : {0.01, 0.3, 0.8, 1.2, 1.55}) {
    const auto w = std::polar(1.0, theta);  // conjugate of the velocity there, over U
    const auto z = 2 * jet.width / std::numbers::pi * (std::atan(w) + std::atanh(w));
    CHECK(jet.surface(z.real()) == Approx(z.imag()).epsilon(1e-9));
    CHECK(jet.surface(jet.surface(z.real())) == Approx(z.real()).epsilon(1e-9));
  }
  CHECK(jet.surface(0.6) == Approx(jet.width / 2).epsilon(1e-6));  // the sheet that flows off
}
