// Back in time, and the time step against its limits, with real events in a private X server.

#include <string>

#include "tests/catch.hpp"
#include "tests/window/desk.hpp"

using clapotis::testing::Desk;
using clapotis::testing::Place;

TEST_CASE("Left goes one step back, Shift+Left ten, and Right on again to the same bits", "[window]") {
  Desk desk("back");
  desk.start({STAGE2_PROGRAM, "--paused"});
  desk.await("step 0 ");
  desk.key("shift+Right");
  const auto tenth = desk.await("step 10 ");
  desk.key("shift+Right");
  const auto twentieth = desk.await("step 20 ");
  desk.key("Left");
  desk.await("step 19 ");
  desk.key("shift+Left");
  desk.await("step 9 ");
  desk.key("Right");
  CHECK(desk.await("step 10 ") == tenth);
  desk.key("shift+Right");
  CHECK(desk.await("step 20 ") == twentieth);
  desk.key("shift+Left");
  desk.await("step 10 ");
  desk.click_control("back");
  desk.await("step 9 ");
  desk.key("shift+Left");
  desk.await("step 0 ");
  CHECK(desk.await("notice ").find("the oldest moment that is kept") != std::string::npos);
}

TEST_CASE("the time line is dragged to a moment of the run, which pauses, and from there the run goes on",
          "[window]") {
  Desk desk("time-line");
  desk.start({STAGE1_PROGRAM, "drop", "--until", "2"});
  desk.await("paused");
  const auto end = desk.await("step ");
  CHECK(end.find("t=2 ") != std::string::npos);
  const Place line = desk.control("time_line");
  const auto drag_to_middle = [&] {
    desk.drag(line.x + line.width - 12, line.centre_y(), line.centre_x(), line.centre_y());
    double time = 2;
    while (time > 1.2) {  // a moment for each place that the mouse came by
      const auto moment = desk.await("step ");
      time = std::stod(moment.substr(moment.find("t=") + 2));
    }
    return time;
  };
  CHECK(drag_to_middle() > 0.8);
  desk.picture("middle");
  desk.drag(line.centre_x(), line.centre_y(), line.x + line.width + 50, line.centre_y());
  while (desk.await("step ") != end) {
  }
  drag_to_middle();  // seen to have arrived: a key that comes in the frame of its last move is undone by it
  desk.key("space");
  desk.await("running");
  desk.await("paused");  // at t = 2 s again
  CHECK(desk.await("step ") == end);
}

TEST_CASE("a run that diverged marks the particle, and offers a step back or half the time step",
          "[window]") {
  Desk desk("diverged-back");
  desk.start({STAGE2_PROGRAM, "cloud", "--integrator", "explicit_euler", "--set", "dt=0.01"});
  const auto where = desk.await("diverged step ");
  const long step = std::stol(where);
  const auto particle = where.substr(where.find("particle ") + 9);
  desk.await("selected " + particle);
  desk.picture("stopped");
  desk.click_control("diverged:back");
  desk.await("diverged no");
  desk.await("step " + std::to_string(step - 2) + " ");
  desk.picture("before");
  desk.key("shift+Right");
  CHECK(desk.await("diverged step ") == where);
  desk.key("Left");
  desk.await("diverged no");
  desk.key("shift+Right");
  desk.await("diverged step ");
  desk.click_control("diverged:dt");
  desk.await("parameter dt=0.005");
  desk.await("started 2");
}

TEST_CASE("each limit of the time step has a line of its own", "[window]") {
  Desk desk("limits");
  desk.start({STAGE2_PROGRAM, "cloud", "--paused"});
  for (const auto* limit : {"limit:acoustic", "limit:contact"}) CHECK(desk.control(limit).width > 30);
  desk.picture("calm");
}
