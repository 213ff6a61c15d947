// What the mouse does to the water of the sandbox, with real events in a private X server.

#include <string>

#include "tests/catch.hpp"
#include "tests/window/desk.hpp"

using clapotis::testing::Desk;
using clapotis::testing::Pixel;

namespace {

/// A pixel of the tank, 2.4 m x 1.4 m, that is 0.5 m deep in water.
Pixel spot_of(Desk& desk, double x, double y) { return desk.pixel_of(x, y, 2.4, 1.4); }

/// A desk with the sandbox on it.
void open_sandbox(Desk& desk, const std::vector<std::string>& more = {}) {
  std::vector<std::string> command{STAGE5_PROGRAM, "sandbox", "--set", "spacing=0.04"};
  command.insert(command.end(), more.begin(), more.end());
  desk.start(command);
  desk.await("scene sandbox");
  desk.await("tool pull");
}

}  // namespace

TEST_CASE("the pressed mouse pulls the water, follows, and lets go", "[window]") {
  Desk desk("pull");
  open_sandbox(desk);
  const Pixel from = spot_of(desk, 1.2, 0.5), to = spot_of(desk, 1.4, 0.7);
  desk.press(from.x, from.y);
  CHECK(desk.await("hand pulls ").starts_with("1.2"));
  desk.move(to.x, to.y);
  CHECK(desk.await("hand pulls ").starts_with("1.4"));
  desk.picture("pulled");
  desk.release();
  desk.await("hand open");
  desk.press(from.x, from.y, 3);  // the right button does the other
  desk.await("hand pushes ");
  desk.release(3);
  desk.await("hand open");
  desk.click_control("tool:push");
  desk.await("tool push");
  desk.press(from.x, from.y);
  desk.await("hand pushes ");
  desk.release();
  desk.await("hand open");
}

TEST_CASE("drops are added and erased with the mouse, walls drawn where there is no water", "[window]") {
  Desk desk("add_and_erase");
  open_sandbox(desk, {"--paused"});
  const int before = std::stoi(desk.await("particles "));
  const Pixel air = spot_of(desk, 0.6, 1.0), water = spot_of(desk, 1.8, 0.2), wall = spot_of(desk, 1.2, 0.9);
  desk.click_control("tool:add");
  desk.await("tool add");
  desk.click(air.x, air.y);
  CHECK(std::stoi(desk.await("particles ")) > before + 30);
  desk.click(air.x, air.y);
  desk.await("notice there is no room for a drop");
  desk.click_control("tool:erase");
  desk.await("tool erase");
  desk.click(air.x, air.y);
  CHECK(std::stoi(desk.await("particles ")) == before);
  desk.click_control("tool:obstacle");
  desk.await("tool obstacle");
  desk.drag(wall.x, wall.y, wall.x + 100, wall.y);
  CHECK(std::stoi(desk.await("obstacles ")) > 10);
  desk.click(water.x, water.y);
  desk.await("notice there is liquid");
  desk.picture("wall");
  desk.key("r");
  desk.await("obstacles 0");
}

TEST_CASE("a tank that is grabbed follows the mouse and returns", "[window]") {
  Desk desk("grab");
  open_sandbox(desk);
  desk.click_control("tool:grab");
  desk.await("tool grab");
  const Pixel at = spot_of(desk, 1.2, 1.0), aside = spot_of(desk, 1.6, 1.0);
  desk.press(at.x, at.y);
  desk.move(aside.x, aside.y);
  desk.await("tank moved on");
  desk.picture("shaken");
  desk.release();
  desk.await("tank moved off");
}

TEST_CASE("the probe looks at a particle in the sandbox, too", "[window]") {
  Desk desk("sandbox_probe");
  open_sandbox(desk, {"--paused"});
  desk.click_control("tool:probe");
  desk.await("tool probe");
  const Pixel water = spot_of(desk, 1.2, 0.2);
  desk.click(water.x, water.y);
  CHECK(desk.await("selected ") != "none");
}
