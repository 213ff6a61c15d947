// The tab with the exercises of the stage, driven as a class drives it.

#include <string>

#include "tests/catch.hpp"
#include "tests/window/desk.hpp"

using clapotis::testing::Desk;

TEST_CASE("an exercise sets its scene, runs to its end, and its answer is checked when it is asked for",
          "[window]") {
  Desk desk("lesson");
  desk.start({STAGE1_PROGRAM, "bounce", "--paused"});
  desk.await("tab scene");
  desk.click_control("tab:lesson");
  desk.await("tab lesson");
  desk.picture("predict");
  desk.click_control("lesson:run1");
  desk.await("scene drop");
  desk.await("integrator explicit_euler");
  desk.await("parameter dt=0.004");
  desk.await("check 1 holds");
  desk.await("run 1 done");
  desk.await("paused");
  desk.picture("measured");
  desk.click_control("lesson:answer");
  desk.await("answer on");
  desk.picture("answer");
  desk.key("F2");
  desk.await("language french");
  desk.picture("french");
  desk.click_control("lesson:next");
  desk.await("exercise 2");
  desk.await("answer off");
  desk.picture("compare");
  desk.click_control("lesson:previous");
  desk.await("exercise 1");
  desk.click_control("tab:scene");
  desk.await("tab scene");
  desk.picture("scene");
}

TEST_CASE("a run of an exercise that is changed by hand counts no more until it is run again", "[window]") {
  Desk desk("lesson_changed");
  desk.start({STAGE1_PROGRAM, "--paused"});
  desk.click_control("tab:lesson");
  desk.await("exercise 1");
  for (int page = 2; page <= 3; ++page) {
    desk.click_control("lesson:next");
    desk.await("exercise " + std::to_string(page));
  }
  desk.click_control("lesson:run2");
  desk.await("run 2 running");
  desk.key("r");
  desk.await("run 2 changed");
  desk.picture("changed");
  desk.click_control("lesson:run2");
  desk.await("run 2 done");
  desk.await("check 2 holds");
}

TEST_CASE("a run that diverges gives the step at which it did", "[window]") {
  Desk desk("lesson_diverges");
  desk.start({STAGE4_PROGRAM, "--paused"});
  desk.click_control("tab:lesson");
  desk.await("exercise 1");
  desk.click_control("lesson:run1");
  desk.await("diverged step 42");
  desk.await("check 1 holds");
  desk.await("run 1 done");
  desk.picture("diverged");
}
