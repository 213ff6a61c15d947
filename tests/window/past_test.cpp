// Back in time, without any window: a moment that is shown again has the bits that it had, and so has all
// that follows from it.

#include "common/window/past.hpp"

#include <map>

#include "common/simulation/errors.hpp"
#include "common/simulation/tools.hpp"
#include "common/window/session.hpp"
#include "stage1_bouncing/scenes.hpp"
#include "stage2_cloud/scenes.hpp"
#include "stage3_grid/scenes.hpp"
#include "stage4_sph/scenes.hpp"
#include "stage5_extensions/scenes.hpp"
#include "tests/catch.hpp"
#include "tests/window/played.hpp"

using namespace clapotis;
using clapotis::testing::frame, clapotis::testing::options_of, clapotis::testing::plenty;

namespace {

std::string state_of(Session& session) {
  StateBytes state;
  session.simulation().pass_state(state);
  return session.simulation().integrator() + state.bytes();
}

/// What each step of a run came to, as it was seen the first time.
using Diary = std::map<long, std::string>;

void note(Diary& diary, Session& session) { diary[session.simulation().steps()] = state_of(session); }

void live(Diary& diary, Session& session, int steps) {
  for (int k = 0; k < steps; ++k) {
    session.step(1);
    note(diary, session);
  }
}

/// Frames of a window, each of ten steps or so.
void run(Diary& diary, Session& session, int frames) {
  if (session.paused()) session.toggle_pause();
  for (int k = 0; k < frames; ++k) {
    session.advance(10 * session.simulation().dt(), plenty);
    note(diary, session);
  }
}

/// Goes through the known time backwards and forwards, in steps of one and of many, and compares with the
/// diary wherever it has an entry.
void check_past(const Diary& diary, Session& session) {
  const long last = session.simulation().steps(), first = session.past().oldest().step;
  const auto same = [&] {
    const auto entry = diary.find(session.simulation().steps());
    return entry == diary.end() || entry->second == state_of(session);
  };
  for (const int stride : {1, 7}) {
    while (session.simulation().steps() > first) {
      const long before = session.simulation().steps();
      session.step_back(stride);
      REQUIRE(session.simulation().steps() == std::max(before - stride, first));
      REQUIRE(same());
    }
    while (session.simulation().steps() < last) {
      session.step(static_cast<int>(std::min<long>(stride, last - session.simulation().steps())));
      REQUIRE(same());
    }
  }
  REQUIRE(session.past().newest().step == last);
  REQUIRE(same());
}

}  // namespace

TEST_CASE(
    "each step back, and each step on from there, has the bits that it had, in every stage with "
    "several schemes",
    "[window][past]") {
  struct Case {
    Stage stage;
    const char *scene, *integrator;
    Overrides parameters;
  };
  const std::vector<Case> cases{
      {stage1::stage(), "drop", "rk4", {}},
      {stage1::stage(), "bounce", "bogacki_shampine", {}},
      {stage2::stage(), "pair", "symplectic_euler", {}},
      {stage2::stage(), "cloud", "bogacki_shampine", {{"particles", {"30"}}}},
      {stage3::stage(), "cloud", "rk2", {{"particles", {"60"}}}},
      {stage4::stage(), "dam_break", "velocity_verlet", {{"spacing", {"0.1"}}}},
      {stage4::stage(), "elliptical_drop", "symplectic_euler", {{"spacing", {"0.1"}}}},
      {stage5::stage(), "standing_wave", "rk4", {{"spacing", {"0.1"}}}},
      {stage5::stage(), "poiseuille", "velocity_verlet", {}},
  };
  for (const auto& [stage, scene, integrator, parameters] : cases) {
    CAPTURE(stage.name, scene, integrator);
    Session session(stage, options_of(scene, parameters, integrator));
    Diary diary;
    note(diary, session);
    live(diary, session, 12);
    run(diary, session, 3);
    check_past(diary, session);
  }
}

TEST_CASE("the past holds across changes of parameters and of the scheme, and takes them back",
          "[window][past]") {
  const Stage stage = stage4::stage();
  Session session(stage, options_of("dam_break", {{"spacing", {"0.1"}}}));
  Diary diary;
  note(diary, session);
  live(diary, session, 9);
  session.set("gravity", "3");
  note(diary, session);  // the moment after the change counts
  live(diary, session, 9);
  session.choose_integrator("rk2");
  note(diary, session);
  run(diary, session, 3);
  session.set("cfl", "0.7");
  session.set("alpha", "0.2");
  session.set("gravity", "5");
  note(diary, session);
  live(diary, session, 9);
  check_past(diary, session);
  CHECK(session.simulation().parameters().value("gravity") == 5);
  CHECK_FALSE(session.simulation().setup().reference.has_value());

  session.go_to(session.past().oldest().time);
  session.step(8);
  CHECK(session.simulation().parameters().value("gravity") == 9.81);
  CHECK(session.simulation().parameters().value("alpha") == 0.02);
  CHECK(session.simulation().parameters().find("gravity")->origin != Origin::window);
  CHECK(session.simulation().integrator() == "velocity_verlet");
  CHECK(session.simulation().setup().reference.has_value());
}

TEST_CASE("what hands did in the sandbox is undone on the way back and done again on the way on",
          "[window][past]") {
  const Stage stage = stage5::stage();
  Session session(stage, options_of("sandbox", {{"spacing", {"0.04"}},
                                                {"tank_width", {"1.2"}},
                                                {"tank_height", {"1"}},
                                                {"depth", {"0.32"}}}));
  Diary diary;
  note(diary, session);
  live(diary, session, 5);
  const auto at_first = session.simulation().particles().size();
  draw_obstacle(session.simulation(), {0.3, 0.6}, 0.1);
  add_drop(session.simulation(), {0.8, 0.7}, 0.12);
  note(diary, session);
  live(diary, session, 5);
  erase(session.simulation(), {1.1, 0.1}, 0.08);
  hold_hand(session.simulation(), {0.6, 0.4}, 1);
  note(diary, session);
  run(diary, session, 2);
  shake_tank(session.simulation(), {0.5, 0});
  erase(session.simulation(), {0.3, 0.6}, 0.05);
  note(diary, session);
  live(diary, session, 5);
  check_past(diary, session);
  CHECK(session.simulation().model().obstacles().rows() > 0);
  session.step_back(1000000);
  CHECK(session.simulation().particles().size() == at_first);
  CHECK(session.simulation().model().obstacles().rows() == 0);
}

TEST_CASE("particles that left come back, under their names", "[window][past]") {
  const Stage stage = stage5::stage();
  Session session(stage, options_of("channel", {{"spacing", {"1e-3"}}}));
  Diary diary;
  while (session.simulation().system().left == 0) session.step(10);
  session.step_back(3);
  session.toggle_pause();  // a new past from here on
  run(diary, session, 6);
  session.step(5);
  check_past(diary, session);
}

TEST_CASE("running on from the past comes to the same bits, and what lay ahead is forgotten",
          "[window][past]") {
  const Stage stage = stage3::stage();
  Session session(stage, options_of("cloud", {{"particles", {"60"}}}));
  Diary diary;
  run(diary, session, 20);
  const long end = session.simulation().steps();
  session.step_back(static_cast<int>(end / 2));
  CHECK(session.paused());
  CHECK(session.past().newest().step == end);
  session.toggle_pause();
  session.advance(frame, plenty);
  CHECK(session.past().newest().step <= session.simulation().steps());
  CHECK(session.simulation().steps() < end);
  session.toggle_pause();
  session.step(static_cast<int>(end - session.simulation().steps()));
  CHECK(state_of(session) == diary.at(end));

  session.step_back(5);
  session.set("gravity", "0");  // another future
  session.step(5);
  CHECK(session.simulation().steps() == end);
  CHECK(state_of(session) != diary.at(end));
  session.step_back(6);
  CHECK(session.simulation().parameters().value("gravity") != 0);
}

TEST_CASE("a change by hand after the last step is not lost on the way back", "[window][past]") {
  const Stage stage = stage1::stage();
  Session session(stage, options_of("drop"));
  session.step(10);
  session.set("gravity", "1");
  session.step_back(2);
  CHECK(session.simulation().parameters().value("gravity") == 9.81);
  session.step(2);
  CHECK(session.simulation().parameters().value("gravity") == 1);
}

TEST_CASE("a dragged time line shows the last step that is not later", "[window][past]") {
  const Stage stage = stage4::stage();
  Session session(stage, options_of("dam_break", {{"spacing", {"0.1"}}}));  // each step has its own dt
  std::vector<double> times{0};
  for (int k = 0; k < 40; ++k) {
    session.step(1);
    times.push_back(session.simulation().time());
  }
  Session frames(stage, options_of("dam_break", {{"spacing", {"0.1"}}}));
  while (frames.simulation().steps() < 40) frames.advance(frame, plenty);  // the past has gaps
  for (const std::size_t k : {33U, 7U, 12U, 39U, 1U, 0U}) {
    frames.go_to(times[k] + 1e-9);
    CHECK(frames.simulation().steps() == static_cast<long>(k));
    CHECK(frames.simulation().time() == times[k]);
  }
  frames.go_to(1e9);
  CHECK(frames.simulation().steps() == frames.past().newest().step);
  frames.go_to(-1);
  CHECK(frames.simulation().steps() == 0);
}

TEST_CASE("a step back lifts the freeze of a run that diverged, and it diverges again", "[window][past]") {
  const Stage stage = stage3::stage();
  Session session(stage, options_of("cloud", {{"dt", {"0.01"}}}, "explicit_euler"));
  Diary diary;
  note(diary, session);
  while (!session.diverged()) {
    session.step(1);
    note(diary, session);
  }
  const auto reason = *session.diverged();
  session.step_back(1);
  CHECK_FALSE(session.diverged());
  CHECK(session.simulation().steps() == reason.step - 2);
  session.step(1);
  check_past(diary, session);
  CHECK_FALSE(session.diverged());
  session.step(1);
  REQUIRE(session.diverged());
  CHECK(session.diverged()->step == reason.step);
  CHECK(session.diverged()->particle == reason.particle);
  CHECK(std::string(session.diverged()->what()) == reason.what());
}

TEST_CASE("half the step after a divergence starts the scene with it", "[window][past]") {
  const Stage stage = stage3::stage();
  Session session(stage, options_of("cloud", {{"dt", {"0.01"}}}, "explicit_euler"));
  while (!session.diverged()) session.step(1);
  session.halve_step();
  CHECK_FALSE(session.diverged());
  CHECK(session.simulation().steps() == 0);
  CHECK(session.simulation().dt() == 0.005);
  CHECK(session.simulation().integrator() == "explicit_euler");
}

TEST_CASE("a scene that starts anew has no past", "[window][past]") {
  const Stage stage = stage1::stage();
  Session session(stage, options_of("drop"));
  session.step(10);
  session.reset();
  CHECK(session.past().newest().step == 0);
  session.step(10);
  session.choose_scene(1);
  CHECK(session.past().newest().step == 0);
  session.step_back(1);
  CHECK(session.simulation().steps() == 0);
}

TEST_CASE("the plots end at the moment that is shown, and have the rest again on the way on",
          "[window][past]") {
  const Stage stage = stage1::stage();
  Session session(stage, options_of("drop"));
  for (int k = 0; k < 60; ++k) session.advance(frame, plenty);
  const auto whole = session.history().samples();
  session.go_to(0.5);
  const auto half = session.history().samples();
  CHECK(half.back().time == session.simulation().time());
  CHECK(half.size() < whole.size());
  session.go_to(1e9);
  CHECK(session.history().samples().size() == whole.size());
  session.go_to(0.5);
  session.toggle_pause();
  for (int k = 0; k < 3; ++k) session.advance(frame, plenty);
  CHECK(session.history().samples().back().time == session.simulation().time());
  CHECK(session.history().samples().size() == half.size() + 3);
}

TEST_CASE("the past is bounded: old moments become rare, then go, and what is left has its bits",
          "[window][past]") {
  Simulation run(stage1::stage().scene("drop")), again(stage1::stage().scene("drop"));
  const std::array present{&run}, other{&again};
  const std::size_t most = 40;
  Past past({.bytes = std::size_t{1} << 30, .moments = most, .apart = 1, .most_apart = 8});
  past.begin(present);
  for (int k = 0; k < 1000; ++k) {
    run.step();
    if (k == 700) run.set("drag", "0.1");
    past.pass(present, 1);
    REQUIRE(past.size() <= most);
  }
  CHECK(past.newest().step == 1000);
  CHECK(past.oldest().step > 700);
  CHECK(past.oldest().step < 1000 - 100);  // more than 40 steps are in reach
  long before = past.oldest().step;
  for (long step = before; step <= 1000; ++step) {
    const long kept = past.before(step).step;
    CHECK(kept - before <= 8);
    before = kept;
  }
  // In bytes, too.
  StateBytes state;
  run.pass_state(state);
  Past small({.bytes = 5 * state.bytes().size(), .moments = 1000, .apart = 1, .most_apart = 0});
  small.begin(other);
  for (int k = 0; k < 20; ++k) {
    again.step();
    small.pass(other, 1);
  }
  CHECK(small.bytes() <= 5 * state.bytes().size());
  CHECK(small.size() >= 4);
}

TEST_CASE("two simulations are brought back to one instant", "[window][past]") {
  const Stage stage = stage3::stage();
  Simulation left(stage.scene("cloud"), {{"particles", {"20"}}}),
      right(stage.scene("cloud"), {{"particles", {"30"}}}, "rk2");
  const std::array both{&left, &right};
  Past past;
  past.begin(both);
  std::vector<std::string> states;
  for (int k = 0; k < 5; ++k) {
    StateBytes state;
    left.pass_state(state);
    right.pass_state(state);
    states.push_back(state.bytes());
    left.step();
    right.step();
    right.step();
    past.keep(both);
  }
  right.use_integrator("rk4");
  CHECK(past.changed(both));
  past.restore(both, 3);
  CHECK_FALSE(past.changed(both));
  StateBytes state;
  left.pass_state(state);
  right.pass_state(state);
  CHECK(state.bytes() == states[3]);
  CHECK(right.integrator() == "rk2");
}
