// Two sides in a real window, with real mouse and key events.

#include <filesystem>
#include <string>

#include "tests/catch.hpp"
#include "tests/window/desk.hpp"

using clapotis::testing::Desk;

namespace {

const std::string bouncing = STAGE1_PROGRAM, cloud = STAGE2_PROGRAM, grid = STAGE3_PROGRAM,
                  sph = STAGE4_PROGRAM;

}  // namespace

TEST_CASE(
    "B runs the scene twice on one clock, from the start, the mouse chooses what differs, B again ends it",
    "[window]") {
  Desk desk("two-sides");
  desk.start({bouncing, "drop", "--paused", "--set", "dt=0.004"});
  desk.await("step 0 ");
  desk.key("shift+n");
  desk.await("step 10 ");
  desk.key("b");
  desk.await("sides integrator=explicit_euler");
  CHECK(desk.await("notice ").find("./lab compare stage1_bouncing/drop") != std::string::npos);
  desk.await("step 0 ");
  desk.key("shift+n");
  desk.await("right step 10 t=0.04 evaluations=10 ");
  desk.await("step 10 t=0.04 ");
  desk.click_control("contrast");
  desk.await("menu on");
  desk.click_control("contrast:dt");
  desk.await("sides dt=0.008");
  desk.click_control("other");
  desk.await("typing sides:value");
  desk.type("0.001");
  desk.key("Return");
  desk.await("sides dt=0.001");
  desk.key("n");
  desk.await("right step 4 t=0.004 ");
  desk.await("step 1 t=0.004 ");
  desk.click_control("other");
  desk.await("typing sides:value");
  desk.type("-3");
  desk.key("Return");
  CHECK(desk.await("notice dt").find("-3") != std::string::npos);
  desk.click_control("contrast");
  desk.await("menu on");
  desk.click_control("contrast:integrator");
  desk.await("sides integrator=");
  desk.click_control("other");
  desk.await("menu on");
  desk.click_control("other:rk4");
  desk.await("sides integrator=rk4");
  desk.key("space");
  desk.await("running");
  const double before = std::stod(desk.await("time "));
  CHECK(std::stod(desk.await("time ")) > before);
  desk.picture("running");
  desk.key("F12");
  CHECK(std::filesystem::file_size(desk.folder() / desk.await("notice Saved ")) > 1000);
  desk.click_control("sides");
  desk.await("sides off");
  const double alone = std::stod(desk.await("time "));
  CHECK(std::stod(desk.await("time ")) > alone);
}

TEST_CASE("the side that diverges says so in its own half, and the other one goes on", "[window]") {
  Desk desk("one-diverges");
  desk.start(
      {cloud, "cloud", "--integrator", "explicit_euler", "--set", "dt=0.0015", "--set", "particles=200"});
  desk.await("scene cloud");
  desk.key("b");
  desk.await("sides integrator=velocity_verlet");
  desk.await("diverged step ");
  const double before = std::stod(desk.await("time "));
  CHECK(std::stod(desk.await("time ")) > before);
  desk.picture("left-diverged");
  CHECK_FALSE(desk.seen("right diverged step"));
  desk.key("r");
  desk.await("diverged no");
}

TEST_CASE("the grid beside the list: one trajectory, the wheel over either half zooms both", "[window]") {
  Desk desk("grid-beside-list");
  desk.start({grid, "--paused"});
  desk.await("paused");
  desk.click_control("sides");
  desk.await("sides neighbour_search=list");
  desk.key("shift+n");
  const auto right = desk.await("right step 10 ");
  CHECK(right.find("largest=0") != std::string::npos);
  const auto half = desk.control("right_half");
  desk.click(half.centre_x(), half.centre_y(), 4);
  desk.await("view zoom=1.15 ");
  desk.picture("zoomed");
}

TEST_CASE("the handout's formulation beside the consistent one", "[window]") {
  Desk desk("formulations");
  desk.start({sph, "handout", "--paused"});
  desk.await("scene handout");
  desk.key("b");
  desk.await("sides formulation=consistent");
  desk.key("shift+n");
  desk.await("step 10 ");
  desk.picture("formulations");
}
