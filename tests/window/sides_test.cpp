// Two sides of one scene in a session, without any window: the numbers of `./lab compare`.

#include <cmath>

#include "common/runner/comparison.hpp"
#include "common/window/session.hpp"
#include "stage1_bouncing/scenes.hpp"
#include "stage2_cloud/scenes.hpp"
#include "stage3_grid/scenes.hpp"
#include "stage4_sph/scenes.hpp"
#include "tests/catch.hpp"
#include "tests/window/played.hpp"

using namespace clapotis;
using clapotis::testing::frame, clapotis::testing::options_of, clapotis::testing::plenty;

namespace {

Options until_half(const std::string& scene, const Overrides& parameters = {}) {
  auto options = options_of(scene, parameters);
  options.until = {0.5, Origin::flag};
  return options;
}

Side side_of(const Scene& scene, const Overrides& parameters, const std::string& integrator) {
  return {.text = {},
          .stage_title = {},
          .simulation = std::make_shared<Simulation>(scene, parameters, integrator)};
}

/// What can be said of a comparison.
void check_same(const SideBySide& session, const Comparison& headless, const Side& left, const Side& right) {
  CHECK(session.comparison().steps_together() == headless.steps_together());
  REQUIRE(session.comparison().difference().has_value() == headless.difference().has_value());
  if (headless.difference()) {
    CHECK(session.comparison().difference()->largest == headless.difference()->largest);
    CHECK(session.comparison().difference()->rms == headless.difference()->rms);
  }
  CHECK(session.comparison().largest().largest == headless.largest().largest);
  CHECK(session.comparison().largest().time == headless.largest().time);
  const std::pair<const Side*, const Side*> sides[] = {{&session.left(), &left}, {&session.right(), &right}};
  for (const auto& [here, there] : sides) {
    CHECK(here->simulation->time() == there->simulation->time());
    CHECK(here->simulation->system().force_evaluations == there->simulation->system().force_evaluations);
    CHECK(here->energy_drift() == there->energy_drift());
    const auto own = here->history.samples(), other = there->history.samples();
    REQUIRE(own.size() == other.size());
    for (std::size_t k = 0; k < own.size(); ++k) {
      CHECK(own[k].time == other[k].time);
      CHECK((own[k].error == other[k].error || (std::isnan(own[k].error) && std::isnan(other[k].error))));
    }
  }
}

}  // namespace

TEST_CASE("two sides in the window have the differences, errors and evaluations of a comparison without it",
          "[window]") {
  const auto compare = [](const Stage& stage, const Options& options, const Contrast& contrast, Side right) {
    Session session(stage, options);
    session.toggle_side_by_side();
    session.differ_in(contrast.name);
    session.choose_other(contrast.value);
    // frames of no regular length, of which some have no time for more than a step
    for (int k = 0; k < 100000 && !session.paused(); ++k)
      session.advance(0.003 * (1 + k % 7), k % 3 == 0 ? 0 : plenty);
    REQUIRE(session.paused());
    Side left = side_of(stage.scene(options.scene.value), options.parameters, "velocity_verlet");
    Comparison headless(left, right, 0.5, session.sides()->comparison().interval());
    while (headless.advance()) {
    }
    check_same(*session.sides(), headless, left, right);
  };
  const Stage drop = stage1::stage(), grid = stage3::stage(), list = stage2::stage(),
              liquid = stage4::stage();
  SECTION("after each step") {
    compare(drop, until_half("drop"), {"integrator", "explicit_euler"},
            side_of(drop.scene("drop"), {}, "explicit_euler"));
  }
  SECTION("at common instants") {
    compare(drop, until_half("drop"), {"dt", "0.0031"},
            side_of(drop.scene("drop"), {{"dt", {"0.0031"}}}, "velocity_verlet"));
  }
  SECTION("the list of stage 2 beside the grid") {
    const Overrides few{{"particles", {"60"}}};
    compare(grid, until_half("cloud", few), {"neighbour_search", "list"},
            side_of(list.scene("cloud"), few, "velocity_verlet"));
  }
  SECTION("other numbers of particles, whose steps follow the state") {
    compare(liquid, until_half("dam_break", {{"spacing", {"0.125"}}}), {"spacing", "0.2"},
            side_of(liquid.scene("dam_break"), {{"spacing", {"0.2"}}}, "velocity_verlet"));
  }
}

TEST_CASE("the sides differ in one thing only, all else counts for both", "[window]") {
  const Stage stage = stage3::stage();
  Session session(stage, until_half("cloud", {{"particles", {"30"}}}));
  session.step(3);
  session.toggle_side_by_side();
  REQUIRE(session.sides() != nullptr);
  CHECK(session.simulation().steps() == 0);  // both from the start
  CHECK(session.sides()->contrast().name == "neighbour_search");
  session.differ_in("stiffness");
  session.choose_other("1000");
  const auto value = [&](const std::string& name) {
    return std::pair(session.simulation().parameters().value(name),
                     session.sides()->right().simulation->parameters().value(name));
  };
  CHECK(value("stiffness").second == 1000);
  session.set("gravity", "100");
  CHECK(value("gravity") == std::pair(100.0, 100.0));
  session.set("stiffness", "3000");
  CHECK(value("stiffness") == std::pair(3000.0, 1000.0));
  session.set("particles", "20");  // starts both anew
  CHECK(session.simulation().particles().size() == 20);
  CHECK(session.sides()->right().simulation->particles().size() == 20);
  CHECK(value("stiffness") == std::pair(3000.0, 1000.0));
  CHECK_THROWS_AS(session.choose_other("-1"), BadInput);
  CHECK(value("stiffness") == std::pair(3000.0, 1000.0));
  session.choose_integrator("rk2");
  CHECK(session.sides()->right().simulation->integrator() == "rk2");
  session.choose_scene(1);
  CHECK(session.sides()->contrast().name == "neighbour_search");
  session.step(2);
  CHECK(session.simulation().steps() == 2);
  CHECK(session.sides()->right().simulation->steps() == 2);
  session.toggle_side_by_side();
  CHECK(session.sides() == nullptr);
  CHECK(session.simulation().steps() == 2);  // the left one goes on
}

TEST_CASE("when one side diverges the other goes on, on the same clock, when both do, the run has stopped",
          "[window]") {
  const Stage stage = stage3::stage();
  auto options = until_half("cloud", {{"particles", {"40"}}, {"dt", {"0.02"}}});
  options.until = {1.5, Origin::flag};
  Session session(stage, options);
  session.toggle_side_by_side();
  session.differ_in("dt");
  session.choose_other("0.001");
  for (int k = 0; k < 2000 && !session.paused(); ++k) session.advance(frame, plenty);
  REQUIRE(session.diverged());
  CHECK_FALSE(session.sides()->left().runs());
  CHECK(session.sides()->right().runs());
  CHECK_FALSE(session.stopped());
  CHECK(session.time() == 1.5);
  CHECK_FALSE(session.sides()->comparison().difference());
  session.choose_other("0.02");
  session.toggle_pause();
  for (int k = 0; k < 2000 && !session.stopped(); ++k) session.advance(frame, plenty);
  CHECK(session.stopped());
}

TEST_CASE("the printed formulation stands beside the consistent one, which lacks the handout's parameters",
          "[window]") {
  const Stage stage = stage4::stage();
  Session session(stage, until_half("handout", {{"signs", {"printed"}}}));
  session.toggle_side_by_side();
  REQUIRE(session.sides() != nullptr);
  CHECK(session.sides()->contrast().name == "formulation");
  const auto& left = session.simulation();
  const auto& right = *session.sides()->right().simulation;
  CHECK(left.parameters().find("formulation")->text() == "handout");
  CHECK(right.parameters().find("formulation")->text() == "consistent");
  CHECK(left.particles().size() == right.particles().size());
  CHECK(distances(left.particles().position, right.particles().position, 0).largest < 1e-9);
}
