#include "stage2_cloud/scenes.hpp"
#include "tests/catch.hpp"
#include "tests/common/runs.hpp"

using namespace clapotis;
using namespace clapotis::tests;

namespace {

/// Two discs meet head-on and part; the scheme is given steps of 9 ms, a third of the contact.
struct Contact {
  double error;   ///< of the place [px]
  double energy;  ///< gained or lost, of what there was
};
Contact contact(double tolerance) {
  Simulation simulation(stage2::stage().scene("pair"), typed({{"dt", 0.009}, {"tolerance", tolerance}}),
                        "bogacki_shampine");
  const double before = simulation.energy().total();
  run_to(simulation, 1.5);
  return {simulation.error(), std::abs(simulation.energy().total() / before - 1)};
}

}  // namespace

TEST_CASE("through a contact of two discs the embedded pair keeps energy and place as its tolerance says",
          "[stage2]") {
  // The tolerance is of a step, relative to speeds of 200 px/s; a contact takes a hundred steps or so, and
  // the corners of its force are jumps of a derivative that the test of the step sees.
  double before = 1;
  for (const double tolerance : {1e-4, 1e-6, 1e-8}) {
    const auto [error, energy] = contact(tolerance);
    CAPTURE(tolerance, error, energy);
    CHECK(energy < 100 * tolerance);
    CHECK(energy < before / 10);
    CHECK(error < 1e4 * tolerance);  // px, a second after the contact, of 200 px
    before = energy;
  }
}

TEST_CASE("a cloud moved by the embedded pair has the same bits with one thread and with two", "[stage2]") {
  const auto stage = stage2::stage();
  const auto values = typed({{"particles", 200.0}, {"y0", 0.0}, {"dt", 0.005}});
  Simulation one(stage.scene("cloud"), values, "bogacki_shampine", 1),
      two(stage.scene("cloud"), values, "bogacki_shampine", 2);
  run_to(one, 0.6);
  run_to(two, 0.6);
  CHECK(same_state(one, two));
  CHECK(one.system().force_evaluations == two.system().force_evaluations);
  CHECK(one.energy().elastic > 0);  // they do touch
}
