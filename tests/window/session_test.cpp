// What a user can ask of a running stage, without any window.

#include "common/window/session.hpp"

#include <set>

#include "common/runner/saved_state.hpp"
#include "common/simulation/errors.hpp"
#include "common/window/keys.hpp"
#include "stage1_bouncing/scenes.hpp"
#include "stage3_grid/scenes.hpp"
#include "tests/catch.hpp"
#include "tests/window/played.hpp"

using namespace clapotis;
using clapotis::testing::frame, clapotis::testing::options_of, clapotis::testing::plenty;

TEST_CASE("a second of frames simulates a second, at twice the speed two", "[window]") {
  const Stage stage = stage1::stage();
  Session session(stage, options_of("drop"));
  for (int k = 0; k < 60; ++k) session.advance(frame, plenty);
  // What is owed is paid in whole steps: less than one stays open.
  CHECK(session.simulation().time() == Approx(1).margin(session.simulation().dt()));
  session.change_speed(1);
  for (int k = 0; k < 60; ++k) session.advance(frame, plenty);
  CHECK(session.simulation().time() == Approx(3).margin(session.simulation().dt()));
}

TEST_CASE("a step longer than a frame comes due after several frames", "[window]") {
  const Stage stage = stage1::stage();
  Session session(stage, options_of("bounce", {{"dt", {"0.05"}}}));
  session.advance(0.03, plenty);
  CHECK(session.simulation().steps() == 0);
  session.advance(0.03, plenty);
  CHECK(session.simulation().steps() == 1);
}

TEST_CASE("after a stall nothing is caught up", "[window]") {
  const Stage stage = stage1::stage();
  Session session(stage, options_of("drop"));
  session.advance(3600, plenty);
  CHECK(session.simulation().time() <= Pacer::longest_frame);
}

TEST_CASE("a frame whose budget is spent still takes one step, and owes nothing afterwards", "[window]") {
  const Stage stage = stage1::stage();
  Session session(stage, options_of("drop"));
  session.advance(frame, 0);
  CHECK(session.simulation().steps() == 1);
  CHECK_FALSE(session.work().within_budget);
  session.advance(0, plenty);
  CHECK(session.simulation().steps() == 1);
}

TEST_CASE("how many frames it took makes no difference to the state", "[window]") {
  const Stage stage = stage3::stage();
  Session fine(stage, options_of("cloud")), coarse(stage, options_of("cloud"));
  while (fine.simulation().steps() < 100) fine.advance(0.001, plenty);
  while (coarse.simulation().steps() < 100) coarse.advance(0.001, 0);
  const auto& a = fine.simulation().particles();
  const auto& b = coarse.simulation().particles();
  REQUIRE(fine.simulation().steps() == coarse.simulation().steps());
  CHECK((a.position == b.position).all());
  CHECK((a.velocity == b.velocity).all());
}

TEST_CASE(
    "a live parameter acts at once, one of the start begins the scene again, a wrong one changes nothing",
    "[window]") {
  const Stage stage = stage3::stage();
  Session session(stage, options_of("cloud"));
  session.step(3);
  session.set("gravity", "100");
  CHECK(session.simulation().steps() == 3);
  CHECK(session.simulation().parameters().value("gravity") == 100);
  CHECK_THROWS_AS(session.set("gravity", "-1"), BadInput);
  CHECK_THROWS_AS(session.set("particles", "1000000"), BadInput);  // they do not fit
  CHECK(session.simulation().steps() == 3);
  CHECK(session.simulation().parameters().value("particles") == 500);
  session.set("particles", "50");
  CHECK(session.simulation().steps() == 0);
  CHECK(session.simulation().particles().size() == 50);
  CHECK(session.simulation().parameters().value("gravity") == 100);
  session.reset();
  CHECK(session.simulation().parameters().value("gravity") == 100);
  session.restore_defaults();
  CHECK(session.simulation().parameters().value("gravity") == 500);
  CHECK(session.simulation().particles().size() == 500);
}

TEST_CASE("a scene starts with what the command line gave, where it has such a parameter", "[window]") {
  const Stage stage = stage3::stage();
  Session session(stage, options_of("cloud", {{"particles", {"20"}}, {"stiffness", {"1000"}}}));
  session.set("stiffness", "2000");
  session.choose_scene(1);  // pair: it has no number of particles
  CHECK(session.simulation().scene().name == "pair");
  CHECK(session.simulation().parameters().value("stiffness") == 1000);
  session.choose_scene(0);
  CHECK(session.simulation().particles().size() == 20);
}

TEST_CASE("a run that diverges stays where it was last good until it is started again", "[window]") {
  const Stage stage = stage3::stage();
  Session session(stage, options_of("cloud", {{"dt", {"0.01"}}}));
  session.choose_integrator("explicit_euler");
  for (int k = 0; k < 100000 && !session.diverged(); ++k) session.advance(frame, plenty);
  REQUIRE(session.diverged());
  const long steps = session.simulation().steps();
  CHECK(session.simulation().particles().position.allFinite());
  CHECK(session.diverged()->step == steps + 1);
  session.advance(frame, plenty);
  session.step(1);
  CHECK(session.simulation().steps() == steps);
  session.choose_integrator("velocity_verlet");
  CHECK_FALSE(session.diverged());
  CHECK(session.simulation().steps() == 0);
}

TEST_CASE("the run pauses where the command line said, but not where nobody said it", "[window]") {
  const Stage stage = stage1::stage();
  auto options = options_of("drop");
  options.until = {0.1, Origin::law};
  Session endless(stage, options);
  for (int k = 0; k < 60; ++k) endless.advance(frame, plenty);
  CHECK_FALSE(endless.paused());
  options.until = {0.1, Origin::flag};
  Session bounded(stage, options);
  for (int k = 0; k < 60; ++k) bounded.advance(frame, plenty);
  CHECK(bounded.paused());
  CHECK(bounded.simulation().time() == 0.1);
  bounded.toggle_pause();
  bounded.advance(frame, plenty);
  CHECK(bounded.simulation().time() > 0.1);
}

TEST_CASE("no two shortcuts share a key", "[window]") {
  std::set<std::pair<Key, char32_t>> keys;
  for (const auto& shortcut : shortcuts()) CHECK(keys.insert({shortcut.key, shortcut.character}).second);
}

TEST_CASE("a session begins with the state of --resume, and a reset goes back to the start of that run",
          "[window]") {
  const Stage stage = stage3::stage();
  Simulation run(stage.scene("cloud"), {{"particles", {"30"}}}, "rk2");
  for (int k = 0; k < 7; ++k) run.step();
  auto options = options_of("cloud", {{"gravity", {"3"}}});
  options.integrator.value = "rk2";
  options.resume = std::make_shared<SavedState>(copy_state(stage, run));
  Session session(stage, options);
  CHECK(session.simulation().steps() == 7);
  CHECK(session.simulation().integrator() == "rk2");
  CHECK(session.simulation().particles().size() == 30);
  CHECK(session.simulation().parameters().value("gravity") == 3);
  session.step(1);
  CHECK(session.simulation().steps() == 8);
  session.reset();
  CHECK(session.simulation().steps() == 0);
  CHECK(session.simulation().particles().size() == 30);
}
