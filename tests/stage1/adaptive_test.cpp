#include "common/simulation/errors.hpp"
#include "tests/catch.hpp"
#include "tests/stage1/drop.hpp"

using namespace clapotis;
using namespace clapotis::tests;
using Catch::Matchers::ContainsSubstring;

namespace {

const std::string pair = "bogacki_shampine";

/// A run of `drop` in one step of dt = until, which the scheme cuts into as many as it wants.
struct Flight {
  Miss miss;
  long evaluations;
};
Flight flight(double tolerance, double until, Values more = {}) {
  more.insert(more.end(), {{"tolerance", tolerance}, {"dt", until}});
  Simulation simulation(drop(), typed(more), pair);
  simulation.step(until);
  const auto exact = exact_ball().at(until);
  return {{std::abs(position(simulation).y - exact.y), std::abs(velocity(simulation).y - exact.v)},
          simulation.system().force_evaluations};
}

}  // namespace

TEST_CASE("where its tolerance asks for nothing, the embedded pair is a scheme of order 3", "[stage1]") {
  std::vector<double> errors;
  const std::vector<long> steps{8, 16, 32, 64};
  for (const long n : steps) errors.push_back(miss({pair, 3}, {{"tolerance", 1.0}}, exact_ball(), 0.4, n).y);
  CAPTURE(errors);
  CHECK(slope(steps, errors) == Approx(3).margin(0.08));  // the next term of the error, as for other schemes
}

TEST_CASE("the error of the embedded pair in free fall follows its tolerance", "[stage1]") {
  // A step's error grows with dt^3 while it is tested and goes on with one of order dt^4: the steps go with
  // the third root of the tolerance, and what they sum up to with dt^3, so in proportion to it.
  double before = 0;
  for (const double tolerance : {1e-4, 1e-6, 1e-8, 1e-10}) {
    const auto [miss, evaluations] = flight(tolerance, 0.4);
    CAPTURE(tolerance, miss.y, miss.v, evaluations);
    CHECK(miss.either() < tolerance);
    CHECK(miss.either() > 1e-3 * tolerance);  // no more accurate than was asked for
    if (before > 0) CHECK(miss.either() == Approx(before / 100).epsilon(0.6));
    before = miss.either();
  }
}

TEST_CASE("the embedded pair takes three evaluations for a step, and three more for one that it takes again",
          "[stage1]") {
  Simulation simulation(drop(), typed({{"dt", 0.001}}), pair);
  run_steps(simulation, 100);                           // far within the tolerance
  CHECK(simulation.system().force_evaluations == 301);  // the first acceleration is an evaluation of its own
  const auto loose = flight(1e-4, 0.4), tight = flight(1e-7, 0.4);
  CHECK((loose.evaluations - 1) % 3 == 0);
  CHECK((tight.evaluations - 1) % 3 == 0);
  // Steps go with the third root: ten times as many, but for the trials at the start.
  CHECK(static_cast<double>(tight.evaluations) / static_cast<double>(loose.evaluations) > 4);
  CHECK(static_cast<double>(tight.evaluations) / static_cast<double>(loose.evaluations) < 12);
}

TEST_CASE("impacts are found on the path of the embedded pair, within its tolerance", "[stage1]") {
  // The ball has met the floor three times at 1.6 s. An impact that is found a height dy too early turns
  // round a speed that is wrong by (1 + e) g dy/v, twelve times dy at the third, where v = 1.5 m/s.
  for (const double tolerance : {1e-4, 1e-6, 1e-8}) {
    const auto [miss, evaluations] = flight(tolerance, 1.6);
    CAPTURE(tolerance, miss.y, miss.v);
    CHECK(miss.either() < 30 * tolerance);
  }
}

TEST_CASE("infinitely many bounces end in rest for the embedded pair as well", "[stage1]") {
  Simulation simulation(drop(), typed({{"drag", 0.0}, {"dt", 0.05}}), pair);
  run_to(simulation, 4.2);  // 4.0637 s in closed form
  CHECK(position(simulation).y == 0);
  CHECK(velocity(simulation).y == 0);
}

TEST_CASE("the embedded pair remembers nothing: after a divergence it is where it was, bit for bit",
          "[stage1]") {
  const std::string impacts = GENERATE("located", "clamp");
  const Values values{{"dt", 0.03}, {"tolerance", 1e-8}, {"impacts", impacts}};
  Simulation lost(drop(), typed(values), pair), twin(drop(), typed(values), pair);
  run_steps(lost, 41);
  run_steps(twin, 41);
  lost.system().velocity(0, 1) = GENERATE(1e30, std::nan(""));
  CHECK_THROWS_AS(lost.step(), Diverged);
  CHECK(same_state(lost, twin));
  run_steps(lost, 20);
  run_steps(twin, 20);
  CHECK(same_state(lost, twin));
}

TEST_CASE("a step beyond the limits of stability is cut, not warned of, by the embedded pair", "[stage1]") {
  const Values thick{{"drag", 1e4}, {"dt", 0.01}, {"vy0", -1.0}};  // 50 times 2 m/beta
  CHECK(!Simulation(drop(), typed(thick), "rk4").warnings().empty());
  Simulation simulation(drop(), typed(thick), pair);
  CHECK(simulation.warnings().empty());
  run_to(simulation, 0.1);
  CHECK(velocity(simulation).y == Approx(-g * 1e-4).epsilon(1e-3));  // m g/beta
}

TEST_CASE("the tolerance can be changed while the scene runs, and has a range", "[stage1]") {
  Simulation simulation(drop(), typed({{"dt", 0.2}, {"tolerance", 1e-3}}), pair);
  simulation.step();
  const long coarse = simulation.system().force_evaluations;
  simulation.set("tolerance", "1e-9");
  simulation.step();
  CHECK(simulation.system().force_evaluations - coarse > 10 * coarse);
  CHECK(std::isfinite(simulation.error()));  // the closed form still holds
  CHECK_THROWS_WITH(simulation.set("tolerance", "0"),
                    ContainsSubstring("tolerance must be between 1e-12 and 1"));
}
