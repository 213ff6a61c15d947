#include <cmath>
#include <limits>
#include <string>

#include "stage4_sph/scenes.hpp"
#include "tests/catch.hpp"
#include "tests/stage4/brute_force.hpp"
#include "tests/stage4/clouds.hpp"
#include "tests/stage4/state.hpp"

using namespace clapotis;
using namespace clapotis::tests;
using Catch::Matchers::ContainsSubstring;

namespace {

Scene scene(const std::string& name) { return stage4::stage().scene(name); }

const std::string at_one_point = "two particles of the liquid were at one point (times: ";

}  // namespace

TEST_CASE("two particles of a liquid at one point do not push each other, and the run says so", "[stage4]") {
  const std::string kernel = GENERATE("cubic_spline", "wendland_c2");
  const std::string density = GENERATE("continuity", "summation");
  const double speed = GENERATE(0.0, 1.0);
  Cloud cloud{.position = Vectors::Constant(2, 2, 0.25), .velocity = Vectors(2, 2)};
  cloud.velocity << 0, 0, speed, -speed;
  cloud.density = Column::Constant(2, 1010);  // a pressure of 1 % of rho c^2
  Simulation sim(scene_of(cloud), typed({{"kernel", kernel}, {"density", density}, {"tension", "yes"}}));
  CAPTURE(kernel, density, speed);
  REQUIRE(sim.warnings().size() == 1);
  CHECK(sim.warnings().front() == at_one_point + "1); no pressure parts them");
  CHECK((sim.system().acceleration == 0).all());
  run_steps(sim, 10);
  CHECK(all_finite(sim.particles()));
}

TEST_CASE("particles of a liquid so near that directions lose their digits push each other oppositely",
          "[stage4]") {
  const std::string kernel = GENERATE("cubic_spline", "wendland_c2");
  for (const double gap : {5e-324, 1e-310, 1e-170, 1e-155, 1e-141, 1e-139, 1e-100, 1e-30, 1e-17, 1e-10}) {
    Cloud cloud{.position = Vectors(2, 2), .velocity = Vectors(2, 2)};
    cloud.position << 0, 0, gap, gap;
    cloud.velocity << 1, 1, -1, 0;
    cloud.density = Column::Constant(2, 1010);
    Simulation sim(scene_of(cloud), typed({{"kernel", kernel}, {"nu", 0.1}}));
    CAPTURE(kernel, gap);
    if (gap > 1e-120) CHECK(sim.warnings().empty());  // nearer than that counts as one point
    const Vectors a = sim.system().acceleration;
    CHECK(a.allFinite());
    CHECK((a.row(0) == -a.row(1)).all());
  }
}

TEST_CASE("pairs at one point in a crowd are counted, and everyone feels the right force", "[stage4]") {
  const std::string density = GENERATE("continuity", "summation");
  Cloud cloud = random_cloud(1, 31);
  cloud.position.row(100) = cloud.position.row(7);
  cloud.position.row(399) = cloud.position.row(7);  // three at one point are three pairs
  cloud.position.row(200) = cloud.position.row(201);
  Simulation sim(scene_of(cloud), typed({{"density", density}, {"tension", "yes"}}));
  REQUIRE(sim.warnings().size() == 1);
  CHECK_THAT(sim.warnings().front(), ContainsSubstring(at_one_point + "4)"));
  const auto exact = brute_force(Liquid::from(sim.parameters()), cloud.position, cloud.velocity,
                                 cloud.density, Vectors(0, 2));
  sim.look([&](const System& s) {
    CHECK(difference(s.acceleration.col(0), exact.ax) < 1e-12);  // as in the sweep's own tests
    CHECK(difference(s.acceleration.col(1), exact.ay) < 1e-12);
  });
}

TEST_CASE("seven hundred particles in one cell feel the right force", "[stage4]") {
  const std::string density = GENERATE("continuity", "summation");
  Cloud cloud = random_cloud(1, 32, 1 / std::sqrt(700.0));
  cloud.position *= 0.09;  // the support is 0.15
  Simulation sim(scene_of(cloud), typed({{"density", density}}));
  REQUIRE(sim.particles().size() == 700);
  CHECK(sim.model().count_pairs(sim.particles()).neighbours == 700 * 699);
  const auto exact = brute_force(Liquid::from(sim.parameters()), cloud.position, cloud.velocity,
                                 cloud.density, Vectors(0, 2));
  sim.look([&](const System& s) {
    CHECK(difference(s.density, exact.density) < 1e-12);
    CHECK(difference(s.acceleration.col(0), exact.ax) < 1e-12);
    CHECK(difference(s.acceleration.col(1), exact.ay) < 1e-12);
  });
}

TEST_CASE("a particle of a liquid that is nowhere disturbs no other, and the run finds it out", "[stage4]") {
  const std::string density = GENERATE("continuity", "summation");
  const auto scheme = GENERATE(from_range(schemes()));
  const double lost =
      GENERATE(std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::infinity());
  Simulation sim(scene("dam_break"), typed({{"spacing", 0.1}, {"density", density}}), scheme.name);
  Simulation without(scene("dam_break"), typed({{"spacing", 0.1}, {"density", density}}), scheme.name);
  run_steps(sim, 5);
  run_steps(without, 5);
  sim.system().position(37, 0) = lost;
  without.system().position(37, 0) = 1e9;
  Vectors a, b;
  sim.look([&](const System& s) { a = s.acceleration; });
  without.look([&](const System& s) { b = s.acceleration; });
  CAPTURE(density, scheme.name, lost);
  for (Index i = 0; i < a.rows(); ++i)  // gone is gone; the sums run in another order
    if (i != 37) REQUIRE(norm(row(a, i) - row(b, i)) < 1e-10 * norm(row(b, i)));
  try {
    sim.step();
    FAIL("the run went on");
  } catch (const Diverged& diverged) {
    CHECK(diverged.step == 6);
    CHECK(diverged.particle == 37);
  }
  CHECK(sim.steps() == 5);
  CHECK(all_finite(sim.particles()));
}

TEST_CASE("a velocity or a density that is not a number is found at once", "[stage4]") {
  const std::string what = GENERATE("velocity", "density");
  const auto scheme = GENERATE(from_range(schemes()));
  Simulation sim(scene("dam_break"), typed({{"spacing", 0.1}}), scheme.name);
  run_steps(sim, 5);
  if (what == "velocity")
    sim.system().velocity(50, 1) = std::nan("");
  else
    sim.system().density(50) = std::nan("");
  CAPTURE(what, scheme.name);
  try {
    sim.step();
    FAIL("the run went on");
  } catch (const Diverged& diverged) {
    CHECK(diverged.particle == 50);
    CHECK_THAT(diverged.what(), ContainsSubstring("is not a number"));
  }
  CHECK(all_finite(sim.particles()));
}
