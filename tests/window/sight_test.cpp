// How a scene is looked at, and what a slider spans: plain arithmetic, without any window.

#include "common/window/sight.hpp"

#include "common/window/slider_span.hpp"
#include "common/window/step_light.hpp"
#include "stage3_grid/scenes.hpp"
#include "stage4_sph/scenes.hpp"
#include "tests/catch.hpp"

using namespace clapotis;

namespace {

const Box area{{0, 0}, {880, 500}};

Simulation& cloud() {
  static const Stage stage = stage3::stage();
  static Simulation simulation(stage.scene("cloud"));
  return simulation;
}

}  // namespace

TEST_CASE("zooming keeps the point of the world below the mouse", "[window]") {
  Sight sight;
  const auto picture = describe("stage", cloud());
  for (const double factor : {1.15, 4.0, 0.3, 1000.0, 1e-6}) {  // the last two reach the ends of the zoom
    const auto before = sight.view(picture, area, 1);
    const Point mouse{300, 200};
    sight.zoom_at(before, mouse, factor);
    const auto after = sight.view(picture, area, 1);
    CHECK((after.to_world(mouse) - before.to_world(mouse)).norm() == Approx(0).margin(1e-9));
  }
  sight.show_whole_scene();
  const auto whole = sight.view(picture, area, 1);
  CHECK(whole.pixels_per_unit == fit(picture, area, 1).pixels_per_unit);
}

TEST_CASE("dragging moves the world with the mouse", "[window]") {
  Sight sight;
  const auto picture = describe("stage", cloud());
  const auto before = sight.view(picture, area, 1);
  sight.move_by(before, {30, -20});
  const auto after = sight.view(picture, area, 1);
  const Point was = before.to_pixel(100, 100), is = after.to_pixel(100, 100);
  CHECK(is.x - was.x == Approx(30));
  CHECK(is.y - was.y == Approx(-20));
}

TEST_CASE("a particle is selected where it is drawn, and none beside all of them", "[window]") {
  Sight sight;
  const auto picture = describe("stage", cloud());
  const auto view = sight.view(picture, area, 1);
  for (const Index i : {0, 17, 499}) {
    const auto r = row(cloud().particles().position, i);
    sight.select_at(cloud(), view, view.to_pixel(r.x, r.y), 0);
    CHECK(sight.viewpoint.chosen == i);
  }
  sight.select_at(cloud(), view, view.to_pixel(400, 100), 0);  // below the cloud, which starts at y = 200 px
  CHECK_FALSE(sight.viewpoint.chosen);
}

TEST_CASE("stepping through the particles goes round", "[window]") {
  Sight sight;
  sight.select_next(cloud(), -1);
  CHECK(sight.viewpoint.chosen == 499);
  sight.select_next(cloud(), 1);
  CHECK(sight.viewpoint.chosen == 0);
}

TEST_CASE("the range of the colours grows at once and shrinks late, unless it is locked", "[window]") {
  ColourRange range;
  const auto follow = [&](double greatest) { return range.follow(0, greatest).second; };
  CHECK(follow(120) == 150);
  CHECK(follow(149) == 150);
  CHECK(follow(60) == 150);
  CHECK(follow(40) == 50);
  CHECK(follow(51) == 75);
  range.locked = true;
  CHECK(follow(1000) == 75);
  CHECK(follow(0.1) == 75);
  range.locked = false;
  CHECK(follow(1000) == 1000);
}

TEST_CASE("a range of colours around zero stays around zero, one between two values ends at round ones",
          "[window]") {
  using Range = std::pair<double, double>;
  CHECK(ColourRange().follow(-0.8, 0.8) == Range{-1, 1});
  CHECK(ColourRange().follow(998.2, 1004.9) == Range{998, 1006});
  CHECK(ColourRange().follow(1000, 1000) == Range{1000, 1000});  // the painter shows it as one colour
  ColourRange range;
  range.follow(-4000, 9000);
  CHECK(range.follow(-3900, 8000) == range.follow(-4000, 9000));
}

TEST_CASE("the time step is amber above 80 % of a limit of stability and red beyond it", "[window]") {
  using enum StepLight::Colour;
  const auto light = [](const char* cfl) {
    return step_light(Simulation(stage4::stage().scene("dam_break"), {{"spacing", {"0.1"}}, {"cfl", {cfl}}}));
  };
  CHECK(light("1").colour == calm);
  CHECK(light("1.5").colour == amber);
  CHECK(light("1.5").share == Approx(1.5 / 1.55));
  CHECK(light("3").colour == red);
  CHECK(light("3").limit.stability);
}

TEST_CASE("a slider spans what is allowed, or what is usual for the scene, and always the present value",
          "[window]") {
  const auto& table = cloud().parameters();
  const auto span = [&](const char* name, double value) {
    return slider_span(*table.find(name), value, cloud());
  };
  CHECK(span("restitution", 0.8).low == 0);
  CHECK(span("restitution", 0.8).high == 1);
  CHECK(span("gravity", 500).high == 2000);
  CHECK(span("gravity", 9000).high == 9000);
  CHECK(span("stiffness", 150000).low > 0);  // zero is not allowed
  CHECK(span("stiffness", 150000).logarithmic);
  CHECK(span("particles", 500).low >= 1);
  CHECK(span("x0", 0).low == -800);  // the width of the box
  CHECK(span("x0", 0).high == 800);
}

TEST_CASE("units, symbols and limits are short enough for a row", "[window]") {
  const auto& table = cloud().parameters();
  CHECK(printed_unit(*table.find("gravity"), "px") == "px/s²");
  CHECK(printed_symbol(*table.find("drag")) == "β");
  CHECK(printed_symbol(*table.find("vx0")) == "vx₀");
  CHECK(printed_symbol({.name = "reference_density", .symbol = "rho_0", .unit = {}}) == "ρ₀");
  CHECK(short_range(table.find("restitution")->range) == "0 … 1");
  CHECK(short_range(table.find("gravity")->range) == "≥ 0");
  CHECK(short_range(table.find("stiffness")->range) == "> 0");
  CHECK(short_range(any_number).empty());
  CHECK(short_number(150000) == "150000");
  CHECK(short_number(0.00105312) == "0.001053");
}
