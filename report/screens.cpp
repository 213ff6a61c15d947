// Takes the pictures of real windows that the report shows: programs in a private X server, driven by real
// key and mouse events, each waited for by what the program says it shows.
//
//   screens DIR

#include <cairo/cairo.h>

#include <cstdio>
#include <exception>
#include <filesystem>
#include <stdexcept>
#include <string>

#include "tests/window/desk.hpp"

namespace {

using clapotis::testing::Desk;
namespace fs = std::filesystem;

const std::string bouncing = STAGE1_PROGRAM, cloud = STAGE2_PROGRAM, liquid = STAGE4_PROGRAM;
constexpr int width = 1280, height = 720;  // of the window, in the upper left corner of the screen

/// The part of the screen that the window fills.
void crop(const fs::path& screen, const fs::path& file) {
  auto* whole = cairo_image_surface_create_from_png(screen.c_str());
  auto* part = cairo_image_surface_create(CAIRO_FORMAT_RGB24, width, height);
  auto* cairo = cairo_create(part);
  cairo_set_source_surface(cairo, whole, 0, 0);
  cairo_paint(cairo);
  cairo_destroy(cairo);
  const auto status = cairo_surface_write_to_png(part, file.c_str());
  cairo_surface_destroy(part);
  cairo_surface_destroy(whole);
  if (status != CAIRO_STATUS_SUCCESS) throw std::runtime_error("cannot write " + file.string());
}

void save(Desk& desk, const fs::path& folder, const std::string& name) {
  const auto file = folder / (name + ".png");
  crop(desk.picture(name), file);
  std::printf("%s\n", file.c_str());
}

// Each stands still when its picture is taken: at an instant that does not depend on the machine, and never
// between two frames.

/// A dam break, with its panel.
void dam_break(const fs::path& folder) {
  Desk desk("dam_break");
  desk.start({liquid, "dam_break", "--set", "spacing=0.04", "--until", "0.6"});
  desk.await("paused");
  save(desk, folder, "dam_break");
}

/// The printed scheme beside Verlet: what the first does to the energy of a fall.
void two_sides(const fs::path& folder) {
  Desk desk("two_sides");
  desk.start({bouncing, "drop", "--integrator", "explicit_euler", "--set", "dt=0.02", "--until", "1.35",
              "--beside", "integrator=velocity_verlet"});
  desk.await("sides integrator=velocity_verlet");
  desk.await("paused");
  save(desk, folder, "two_sides");
}

/// Inside a particle: its neighbours, the forces on it law by law, the kernel that weighs them.
void kernel(const fs::path& folder) {
  Desk desk("kernel");
  desk.start({liquid, "dam_break", "--set", "spacing=0.1", "--until", "0.6"});
  desk.await("paused");
  desk.key("k");
  desk.await("kernel on");
  save(desk, folder, "kernel");
}

/// An exercise with its answer, and what its runs gave.
void lesson(const fs::path& folder) {
  Desk desk("lesson");
  desk.start({cloud, "--paused"});
  desk.await("tab scene");
  desk.click_control("tab:lesson");
  desk.await("tab lesson");
  for (const std::string run : {"1", "2"}) {
    desk.click_control("lesson:run" + run);
    desk.await("run " + run + " done");
  }
  desk.click_control("lesson:answer");
  desk.await("answer on");
  save(desk, folder, "lesson");
}

}  // namespace

int main(int argc, char** argv) {
  if (argc != 2) {
    std::fputs("usage: screens DIR\n", stderr);
    return 2;
  }
  try {
    const fs::path folder = argv[1];
    fs::create_directories(folder);
    dam_break(folder);
    two_sides(folder);
    kernel(folder);
    lesson(folder);
  } catch (const std::exception& error) {
    std::fprintf(stderr, "screens: %s\n", error.what());
    return 4;
  }
  return 0;
}
