// Letters and colours of the window, changed while it is open.

#include <cstdlib>

#include "tests/catch.hpp"
#include "tests/window/desk.hpp"

using clapotis::testing::Desk;

TEST_CASE("F4 makes letters larger up to twice their size, F3 changes the theme", "[window]") {
  Desk desk("look");
  desk.start({STAGE1_PROGRAM, "--paused", "--scale", "1"});
  desk.await("theme light");
  const auto before = desk.control("pause");
  for (const char* scale : {"scale 1.25", "scale 1.5", "scale 1.75", "scale 2"}) {
    desk.key("F4");
    desk.await(scale);
  }
  desk.key("F3");
  desk.await("theme dark");
  desk.picture("twice_and_dark");
  const auto after = desk.control("pause");
  CHECK(std::abs(after.height - 2 * before.height) <= 2);  // whole pixels
  desk.key("space");  // and the window goes on as before
  desk.await("running");
  desk.key("F4");
  desk.await("scale 1");
  CHECK(desk.control("pause").height == before.height);
  desk.click_control("dark");
  desk.await("theme light");
}

TEST_CASE("a window can be opened dark", "[window]") {
  Desk desk("dark");
  desk.start({STAGE1_PROGRAM, "--theme", "dark", "--paused"});
  desk.await("theme dark");
  desk.key("Escape");
  CHECK(desk.await_exit() == 0);
}
