// The window of a stage, driven as a user drives it: real mouse and key events in a private X server. What is
// awaited are lines of CLAPOTIS_TRACE, each of which says that the frame that shows the change is on the
// screen.

#include <cstdlib>
#include <filesystem>
#include <string>

#include "common/window/display.hpp"
#include "tests/catch.hpp"
#include "tests/window/desk.hpp"

using namespace clapotis;
using clapotis::testing::Desk;
using clapotis::testing::Pixel;
using clapotis::testing::Place;

namespace {

const std::string stage1 = STAGE1_PROGRAM, stage2 = STAGE2_PROGRAM, stage3 = STAGE3_PROGRAM,
                  stage4 = STAGE4_PROGRAM;

/// Where a point of a scene of 800 x 600 px is drawn.
Pixel pixel_of(Desk& desk, double x, double y) { return desk.pixel_of(x, y, 800, 600); }

/// Simulated time is told again and again while the scene runs, however fast this machine paints.
void await_progress(Desk& desk) {
  const double before = std::stod(desk.await("time "));
  CHECK(std::stod(desk.await("time ")) > before);
}

/// Drags a slider's grab from the middle of its field to `share` of its width.
void drag_slider(Desk& desk, const std::string& name, double share) {
  const Place place = desk.control(name);
  desk.drag(place.centre_x(), place.centre_y(), place.x + static_cast<int>(share * place.width),
            place.centre_y());
}

void type_value(Desk& desk, const std::string& name, const std::string& text) {
  const Place place = desk.control(name);
  desk.control_click(place.centre_x(), place.centre_y());
  desk.await("typing " + name);
  desk.type(text);
  desk.key("Return");
  desk.await("typing nothing");
}

}  // namespace

TEST_CASE("the window opens on the first scene and runs, and Esc ends it", "[window]") {
  Desk desk("opens");
  desk.start({stage3});
  desk.await("scene cloud");
  await_progress(desk);
  CHECK(desk.title().starts_with("Stage 3 - grid | cloud | t = "));
  desk.picture("running");
  desk.key("Escape");
  desk.await("closed");
  CHECK(desk.await_exit() == 0);
}

TEST_CASE("Space runs and pauses, N takes a step, Shift+N ten, R starts again", "[window]") {
  Desk desk("steps");
  desk.start({stage2, "--paused"});
  desk.await("step 0 ");
  desk.key("n");
  const auto first = desk.await("step 1 ");
  desk.key("shift+n");
  desk.await("step 11 ");
  desk.key("r");
  desk.await("step 0 t=0 ");
  desk.key("Right");
  CHECK(desk.await("step 1 ") == first);  // the same seed gives the same run
  desk.key("space");
  desk.await("running");
  desk.await("time ");
  desk.key("space");
  desk.await("paused");
}

TEST_CASE("the buttons do what their keys do", "[window]") {
  Desk desk("buttons");
  desk.start({stage2, "--paused"});
  desk.await("step 0 ");
  desk.click_control("step");
  desk.await("step 1 ");
  desk.click_control("pause");
  desk.await("running");
  desk.click_control("pause");
  desk.await("paused");
  desk.click_control("reset");
  desk.await("step 0 ");
  desk.click_control("faster");
  desk.await("speed 2");
  desk.click_control("slower");
  desk.await("speed 1");
  desk.click_control("help");
  desk.await("help on");
  desk.picture("help");
}

TEST_CASE("a live parameter follows its slider without starting the scene again", "[window]") {
  Desk desk("slider");
  desk.start({stage3});
  desk.await("started 1");
  await_progress(desk);
  drag_slider(desk, "gravity", 0.9);
  const double dragged = std::stod(desk.await("parameter gravity="));
  CHECK(dragged > 500);
  CHECK(dragged < 2000);
  desk.await("time ");
  CHECK_FALSE(desk.seen("started 2"));
  desk.picture("dragged");
}

TEST_CASE("a value is typed after Ctrl-click, and one that is not allowed is refused and changes nothing",
          "[window]") {
  Desk desk("typing");
  desk.start({stage2, "--paused"});
  desk.await("paused");
  type_value(desk, "gravity", "300");
  desk.await("parameter gravity=300");
  type_value(desk, "gravity", "-3");
  const auto refusal = desk.await("notice ");
  CHECK(refusal.find("gravity = -3") != std::string::npos);
  CHECK_FALSE(desk.seen("parameter gravity=-3"));
  desk.picture("refused");
  // Esc gives up what was typed, and does not close the window.
  const Place place = desk.control("restitution");
  desk.control_click(place.centre_x(), place.centre_y());
  desk.await("typing restitution");
  desk.type("0.5");
  desk.key("Escape");
  desk.await("typing nothing");
  desk.key("n");
  desk.await("step 1 ");
  CHECK_FALSE(desk.seen("parameter restitution"));
}

TEST_CASE("a parameter of the start acts when its slider is let go, by starting the scene again",
          "[window]") {
  Desk desk("restart");
  desk.start({stage3, "--paused"});
  desk.await("started 1");
  desk.key("n");
  desk.await("step 1 ");
  desk.click_control("restart");
  drag_slider(desk, "particles", 0.4);
  const int particles = std::stoi(desk.await("parameter particles="));
  CHECK(particles >= 1);
  CHECK(particles < 500);
  desk.await("started 2");
  desk.await("step 0 ");
  type_value(desk, "radius", "200");
  CHECK(desk.await("notice ").find("do not fit") != std::string::npos);
  CHECK_FALSE(desk.seen("started 3"));
  desk.click_control("defaults");
  desk.await("parameter particles=500");
}

TEST_CASE("the seed is stepped, and typed", "[window]") {
  Desk desk("seed");
  desk.start({stage3, "--paused"});
  desk.await("paused");
  desk.click_control("seed:more");
  desk.await("parameter seed=2");
  desk.click_control("seed");
  desk.await("typing seed");
  desk.type("17");
  desk.key("Return");
  desk.await("parameter seed=17");
}

TEST_CASE("size, zoom, panel and overlays leave the physics as it is, bit for bit", "[window]") {
  const auto run = [](bool disturbed) {
    Desk desk(disturbed ? "disturbed" : "undisturbed");
    desk.start({stage3, "--paused"});
    desk.await("step 0 ");
    for (int tens = 1; tens <= 6; ++tens) {
      desk.key("shift+n");
      desk.await("step " + std::to_string(10 * tens) + " ");
      if (!disturbed) continue;
      if (tens == 1) {
        desk.resize(900, 600);
        desk.await("resized 900x600");
        desk.picture("smaller");
      } else if (tens == 2) {
        const auto middle = pixel_of(desk, 400, 300);
        desk.click(middle.x, middle.y, 4);
        desk.await("view zoom=1.15");
        desk.drag(middle.x, middle.y, middle.x + 60, middle.y + 20, 2);
        desk.await("view zoom=1.15");
      } else if (tens == 3) {
        desk.resize(60, 40);
        desk.await("resized 60x40");
      } else if (tens == 4) {
        desk.resize(1200, 700);
        desk.await("resized 1200x700");
        desk.key("g");
        desk.await("grid on");
      } else if (tens == 5) {
        desk.key("Tab");
        desk.await("panel off");
        desk.key("c");
        desk.await("colour by force");
        desk.key("v");
        desk.await("velocities on");
        desk.picture("larger");
      }
    }
    desk.key("n");
    return desk.await("step 61 ");
  };
  CHECK(run(true) == run(false));
}

TEST_CASE("a minimised window goes on simulating, and its close button ends the program", "[window]") {
  Desk desk("minimised", Desk::WindowManager::openbox);
  desk.start({stage1});
  await_progress(desk);
  desk.minimise();
  for (int frames = 0; frames < 5; ++frames) desk.await("time ");
  desk.restore();
  desk.await("time ");
  desk.picture("restored");
  desk.ask_to_close();
  desk.await("closed");
  CHECK(desk.await_exit() == 0);
}

TEST_CASE("scenes and integrators are chosen from lists, scenes by PageUp and PageDown as well", "[window]") {
  Desk desk("scenes");
  desk.start({stage2});
  desk.await("scene cloud");
  desk.key("Page_Down");
  desk.await("scene pair");
  desk.key("Page_Up");
  desk.await("scene cloud");
  desk.click_control("scene");
  desk.await("menu on");
  desk.click_control("scene:stack");
  desk.await("scene stack");
  await_progress(desk);
  desk.picture("stack");
  desk.click_control("integrator");
  desk.await("menu on");
  desk.picture("list");
  desk.click_control("integrator:rk4");
  desk.await("integrator rk4");
  desk.click_control("integrator");
  desk.await("menu on");
  desk.key("Escape");  // closes the list only
  desk.await("menu off");
  desk.await("time ");
}

TEST_CASE("a run that diverges stands still on its last good state, and goes on with another integrator",
          "[window]") {
  Desk desk("diverged");
  desk.start({stage2, "cloud", "--integrator", "explicit_euler", "--set", "dt=0.01"});
  const auto where = desk.await("diverged step ");
  CHECK(where.find("particle ") != std::string::npos);
  const auto state = desk.await("step ");
  desk.picture("stopped");
  desk.key("n");  // nothing more can come of it
  desk.click_control("diverged:reset");
  desk.await("started 2");
  desk.await("diverged step ");
  CHECK(desk.await("step ") == state);
  type_value(desk, "dt", "auto");
  desk.click_control("diverged:velocity_verlet");
  desk.await("integrator velocity_verlet");
  desk.await("started 3");
  await_progress(desk);
}

TEST_CASE("a click looks at a particle, comma and period at the one before and after it", "[window]") {
  Desk desk("selection");
  desk.start({stage2, "pair", "--paused"});
  desk.await("paused");
  const auto second = pixel_of(desk, 600, 300);  // the mirror image of the first, at (200, 300)
  desk.click(second.x, second.y);
  desk.await("selected 1");
  desk.picture("probe");
  desk.key("period");
  desk.await("selected 0");
  desk.key("comma");
  desk.await("selected 1");
  const auto nowhere = pixel_of(desk, 400, 500);
  desk.click(nowhere.x, nowhere.y);
  desk.await("selected none");
  desk.key("period");
  desk.await("selected 0");
  desk.key("Escape");
  desk.await("selected none");
}

TEST_CASE("every view has its key", "[window]") {
  Desk desk("views");
  desk.start({stage3});
  await_progress(desk);
  const std::pair<const char*, const char*> keys[] = {
      {"c", "colour by force"}, {"l", "range locked on"}, {"g", "grid on"},    {"v", "velocities on"},
      {"e", "plots off"},       {"Tab", "panel off"},     {"h", "help on"},    {"Escape", "help off"},
      {"F1", "help on"},        {"F1", "help off"},       {"Tab", "panel on"}, {"Up", "speed 2"},
      {"Down", "speed 1"}};
  for (const auto& [key, seen] : keys) {
    desk.key(key);
    desk.await(seen);
  }
  desk.picture("views");
}

TEST_CASE("the wheel zooms about the mouse, the middle button moves the view, Home shows the whole scene",
          "[window]") {
  Desk desk("zoom");
  desk.start({stage3, "--paused"});
  desk.await("view zoom=1 ");
  const auto corner = pixel_of(desk, 100, 100);
  desk.click(corner.x, corner.y, 4);
  desk.await("view zoom=1.15 ");
  const auto kept = pixel_of(desk, 100, 100);
  CHECK(std::abs(kept.x - corner.x) <= 1);
  CHECK(std::abs(kept.y - corner.y) <= 1);
  desk.drag(corner.x, corner.y, corner.x + 40, corner.y - 30, 2);
  desk.await("view zoom=1.15 ");
  desk.key("Home");
  desk.await("view zoom=1 moved=0,0");
}

TEST_CASE("F12 saves a picture beside the program's run, and never over another one", "[window]") {
  Desk desk("picture");
  desk.start({stage1, "drop", "--paused"});
  desk.await("paused");
  for (int saved = 0; saved < 2; ++saved) {
    desk.key("F12");
    const auto file = desk.await("notice Saved ");
    CHECK(std::filesystem::file_size(desk.folder() / file) > 1000);
  }
}

TEST_CASE("a liquid is coloured by what suits the scene, and by the next quantity at each C", "[window]") {
  Desk desk("liquid");
  desk.start({stage4, "--set", "spacing=0.1"});
  desk.await("colour by speed");
  for (const auto* quantity :
       {"pressure", "vorticity", "density_error", "density", "force", "plain", "speed"}) {
    desk.key("c");
    desk.await(std::string("colour by ") + quantity);
    desk.picture(quantity);
  }
  desk.key("Page_Down");
  desk.await("scene still_water");
  desk.await("colour by pressure");
  await_progress(desk);
  desk.key("period");
  desk.await("selected 0");
  desk.picture("probe");
}

TEST_CASE("a time step that the user makes too large is said to be so before the run is lost", "[window]") {
  Desk desk("step-light");
  desk.start({stage4, "--set", "spacing=0.1", "--paused"});
  desk.await("step is calm");
  type_value(desk, "cfl", "1.5");
  desk.await("step is amber");
  desk.picture("amber");
  type_value(desk, "cfl", "4");
  desk.await("step is red");
  CHECK(desk.await("notice ").find("expect the run to diverge") != std::string::npos);
  desk.picture("red");
  type_value(desk, "cfl", "1");
  desk.await("step is calm");
}

TEST_CASE("with --until the run pauses at that time, and can go on", "[window]") {
  Desk desk("until");
  desk.start({stage1, "drop", "--until", "0.25"});
  desk.await("paused");
  CHECK(desk.await("step ").find("t=0.25 ") != std::string::npos);
  desk.key("space");
  await_progress(desk);
}

TEST_CASE("Ctrl-C in the terminal closes the window with exit code 130", "[window]") {
  Desk desk("interrupt");
  desk.start({stage1});
  await_progress(desk);
  desk.interrupt();
  CHECK(desk.await_exit() == 130);
}

TEST_CASE("a display that is set but answers to nobody counts as none", "[window]") {
  unsetenv("DISPLAY");
  CHECK_FALSE(display_available());
  setenv("DISPLAY", ":9999", 1);
  CHECK_FALSE(display_available());
  // Last, as the connection is kept once there is one.
  static const Desk desk("display");
  setenv("DISPLAY", desk.display().c_str(), 1);
  CHECK(display_available());
}
