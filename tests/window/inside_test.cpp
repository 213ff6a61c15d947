// Looking inside a particle, with real events in a private X server.

#include <string>

#include "tests/catch.hpp"
#include "tests/window/desk.hpp"

using clapotis::testing::Desk;

TEST_CASE("K shows the kernel at work on a particle in the middle of the liquid, or on the chosen one",
          "[window]") {
  Desk desk("kernel");
  desk.start({STAGE4_PROGRAM, "dam_break", "--set", "spacing=0.1", "--paused"});
  desk.await("selected none");
  desk.key("k");
  desk.await("kernel on");
  const auto middle = desk.await("selected ");
  CHECK(middle != "none");
  desk.picture("bulk");
  desk.key("period");
  CHECK(desk.await("selected ") == std::to_string(std::stoi(middle) + 1));
  desk.key("k");
  desk.await("kernel off");
  desk.click_control("kernel");
  desk.await("kernel on");
  desk.key("space");  // live
  desk.await("time ");
  desk.picture("running");
  desk.key("Escape");
  desk.await("kernel off");
  desk.await("selected none");
}

TEST_CASE("K shows the law of contact of discs, and says where there is neither", "[window]") {
  {
    Desk desk("contact");
    desk.start({STAGE2_PROGRAM, "pair", "--paused"});
    desk.await("paused");
    desk.key("k");
    desk.await("kernel on");
    desk.picture("contact");
  }
  Desk desk("no_kernel");
  desk.start({STAGE1_PROGRAM, "drop", "--paused"});
  desk.await("paused");
  desk.key("k");
  desk.await("notice This scene has no kernel");
  CHECK_FALSE(desk.seen("kernel on"));
  desk.key("period");  // its forces are seen all the same
  desk.await("selected 0");
  desk.picture("forces");
}

TEST_CASE("on a French keyboard the same keys step through particles and show the kernel", "[window]") {
  Desk desk("french");
  desk.layout("fr");
  desk.start({STAGE3_PROGRAM, "cloud", "--set", "particles=50", "--paused"});
  desk.await("paused");
  desk.key("semicolon");  // the period's key without Shift
  desk.await("selected 0");
  desk.key("period");
  desk.await("selected 1");
  desk.key("comma");
  desk.await("selected 0");
  desk.key("k");
  desk.await("kernel on");
}

TEST_CASE("what is seen inside a particle is saved with the picture", "[window]") {
  Desk desk("inside_picture");
  desk.start({STAGE4_PROGRAM, "dam_break", "--set", "spacing=0.1", "--paused"});
  desk.await("paused");
  desk.key("k");
  desk.await("kernel on");
  desk.key("F12");
  const auto file = desk.await("notice Saved ");
  CHECK(std::filesystem::file_size(desk.folder() / file) > 1000);
}
