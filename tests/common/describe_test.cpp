// What is shown of a liquid: colours, legend, plots, units.

#include "common/runner/describe.hpp"

#include <algorithm>

#include "common/runner/history.hpp"
#include "common/runner/listing.hpp"
#include "common/runner/units.hpp"
#include "common/simulation/errors.hpp"
#include "stage1_bouncing/scenes.hpp"
#include "stage2_cloud/scenes.hpp"
#include "stage3_grid/scenes.hpp"
#include "stage4_sph/scenes.hpp"
#include "stage5_extensions/scenes.hpp"
#include "tests/catch.hpp"

namespace clapotis {
namespace {

/// A scene of stage 4 with few particles.
Simulation liquid(const char* scene, const char* spacing) {
  return Simulation(stage4::stage().scene(scene), {{"spacing", {spacing}}});
}

Picture by(Simulation& simulation, const char* quantity) {
  Viewpoint viewpoint;
  viewpoint.colour_by = quantity;
  return describe("stage", simulation, viewpoint);
}

bool has_curve(const Plot& plot, std::string_view label) {
  return std::ranges::any_of(plot.curves, [&](const Curve& curve) { return curve.label == label; });
}

std::vector<Plot> plots_of(Simulation& simulation) {
  History history;
  history.add(simulation);
  return plots(history, simulation);
}

}  // namespace

TEST_CASE(
    "a liquid can be coloured by what it is: pressure in Pa, density, its error in per cent of both signs",
    "[describe]") {
  auto water = liquid("still_water", "0.05");
  for (const auto* name : {"speed", "pressure", "density_error", "density", "force", "plain"})
    CHECK(std::ranges::count(colourings(water), name) == 1);
  const auto pressure = by(water, "pressure");
  CHECK(pressure.colours.unit == "Pa");
  CHECK(pressure.colours.lo == 0);
  CHECK(pressure.colours.hi == Approx(9810).epsilon(0.06));  // rho g H; the lowest particles are half a
                                                             // spacing above the floor
  CHECK(by(water, "density").colours.unit == "kg/m³");
  CHECK(by(water, "force").colours.unit == "N/m");
  const auto error = by(water, "density_error");
  CHECK(error.colours.unit == "%");
  CHECK(error.colours.lo == -error.colours.hi);
  CHECK(error.colours.map == ColourMap::cool_warm);
  CHECK(error.value.maxCoeff() ==
        Approx(100 * (water.particles().density.maxCoeff() / 1000 - 1)).epsilon(1e-12));
}

TEST_CASE("a liquid that bears tension shows it: its pressures begin below zero", "[describe]") {
  auto patch = liquid("square_patch", "0.05");
  for (int k = 0; k < 20; ++k) patch.step();
  const auto picture = by(patch, "pressure");
  CHECK(picture.colours.lo < 0);
  CHECK(picture.colours.lo >= patch.particles().pressure.minCoeff());
}

TEST_CASE("one drop that flies off does not take the colours from all others", "[describe]") {
  auto water = liquid("dam_break", "0.05");
  water.system().velocity.col(0).setLinSpaced(0, 2);
  water.system().velocity(17, 1) = 500;
  const auto picture = by(water, "speed");
  CHECK(picture.colours.hi > 1.9);
  CHECK(picture.colours.hi <= 2);
}

TEST_CASE("the energies of a liquid are compression instead of springs, and weight only where there is some",
          "[describe]") {
  auto water = liquid("dam_break", "0.1"), drop = liquid("elliptical_drop", "0.1");
  Simulation discs(stage3::stage().scene("cloud"));
  const auto of_water = plots_of(water), of_drop = plots_of(drop), of_discs = plots_of(discs);
  CHECK(has_curve(of_water[0], "compression"));
  CHECK_FALSE(has_curve(of_water[0], "elastic"));
  CHECK(has_curve(of_water[0], "potential"));
  CHECK_FALSE(has_curve(of_drop[0], "potential"));
  CHECK(has_curve(of_discs[0], "elastic"));
  CHECK_FALSE(has_curve(of_discs[0], "compression"));
}

TEST_CASE("energies of a liquid are per metre of depth, those of discs are not", "[describe]") {
  auto water = liquid("dam_break", "0.1");
  Simulation discs(stage3::stage().scene("cloud"));
  Simulation handout(stage4::stage().scene("handout"));
  CHECK(energy_unit(water) == "kg m/s^2");
  CHECK(momentum_unit(water) == "kg/s");
  CHECK(short_energy_unit(water) == "J/m");
  CHECK(plots_of(water)[0].y_label == "E [J/m]");
  CHECK(energy_unit(handout) == "kg px/s^2");
  CHECK(energy_unit(discs) == "kg px^2/s^2");
  CHECK(momentum_unit(discs) == "kg px/s");
  CHECK(plots_of(discs)[0].y_label == "E [kg px²/s²]");
}

TEST_CASE("a stage lists the kernels it has, and only then knows such a list", "[describe]") {
  CHECK(listing(stage4::stage(), "kernels", {}) == "cubic_spline\nwendland_c2\n");
  CHECK_THROWS_WITH(listing(stage4::stage(), "kernel", {}),
                    Catch::Matchers::ContainsSubstring("did you mean kernels?"));
  CHECK_THROWS_WITH(listing(stage3::stage(), "kernels", {}),
                    Catch::Matchers::ContainsSubstring("scenes, parameters, integrators"));
}

TEST_CASE("each scene with a reference shows its shape over the flow, and how far the run is from it",
          "[describe]") {
  for (const auto& stage :
       {stage1::stage(), stage2::stage(), stage3::stage(), stage4::stage(), stage5::stage()})
    for (const auto& scene : stage.scenes) {
      Simulation simulation(scene);
      if (!simulation.setup().reference) continue;
      CAPTURE(stage.name, scene.name);
      simulation.step();
      const auto picture = describe(stage.title, simulation);
      REQUIRE(picture.ghosts);
      CHECK_FALSE(picture.note.empty());
      CHECK_FALSE(picture.ghosts->label.empty());
      const auto& view = simulation.setup().view;
      const auto &x = picture.ghosts->x, &y = picture.ghosts->y;
      CHECK((x >= view.left && x <= view.right && y >= view.bottom && y <= view.top).any());
      if (!simulation.setup().reference->measured) continue;
      CHECK(picture.ghosts->measured_x.size() > 0);
      CHECK(picture.ghosts->measured_x.size() <= simulation.particles().size());
    }
}

TEST_CASE("the profile that a channel is drawn with is that of its particles", "[describe]") {
  Simulation simulation(stage5::stage().scene("poiseuille"));
  while (simulation.time() < 0.1) simulation.step();
  const auto picture = describe("stage", simulation);
  const auto& particles = simulation.particles();
  const double scale = picture.ghosts->measured_x(0) / particles.velocity(0, 0);
  CHECK((picture.ghosts->measured_x - scale * particles.velocity.col(0)).abs().maxCoeff() <
        1e-12 * picture.upper.x());
  CHECK((picture.ghosts->measured_y == particles.position.col(1)).all());
  CHECK(picture.ghosts->measured_x.maxCoeff() <= picture.upper.x());
}

TEST_CASE("the fronts of the experiments are marked while they were measured", "[describe]") {
  auto water = liquid("dam_break", "0.1");
  const auto marks = [&] {
    const auto picture = describe("stage", water);
    Index there = 0;
    if (picture.ghosts)
      for (const double x : picture.ghosts->x) there += std::isfinite(x) ? 1 : 0;
    return there;
  };
  CHECK(marks() == 1);  // the others begin later
  while (water.time() < 0.3) water.step();
  CHECK(marks() == 3);
  const auto picture = describe("stage", water);
  CHECK(picture.note.starts_with("Koshizuka & Oka 1996: "));
  CHECK(picture.note.ends_with(" %"));
}

TEST_CASE("a long measure of error stands in the key of its plot, where it has room", "[describe]") {
  auto water = liquid("dam_break", "0.1");
  const auto error = plots_of(water).at(1);
  CHECK(error.y_label.empty());
  CHECK(has_curve(error, "|front - experiment|/a"));
}

}  // namespace clapotis
