// What is shown of one particle: neighbours, forces by law, the kernel at work.

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <set>

#include "common/runner/describe.hpp"
#include "common/runner/describe_inside.hpp"
#include "common/runner/ink.hpp"
#include "stage1_bouncing/scenes.hpp"
#include "stage2_cloud/scenes.hpp"
#include "stage3_grid/scenes.hpp"
#include "stage4_sph/scenes.hpp"
#include "stage5_extensions/scenes.hpp"
#include "tests/catch.hpp"
#include "tests/common/recording_canvas.hpp"
#include "tests/common/runs.hpp"

using namespace clapotis;
using namespace clapotis::tests;

namespace {

Vector force_of(const Chosen& chosen, std::string_view law) {
  const auto found = std::ranges::find(chosen.forces, law, &ForceArrow::law);
  REQUIRE(found != chosen.forces.end());
  return found->force;
}

/// The last value of the curve that ends highest in the plot: of the sum, where it ends.
double end_of(const Plot& plot) { return plot.curves.back().ys.back(); }

/// The particle of still water that is nearest to (x, y).
Index particle_at(const Simulation& simulation, double x, double y) {
  const auto& r = simulation.particles().position;
  Index found = 0;
  ((r.col(0) - x).square() + (r.col(1) - y).square()).minCoeff(&found);
  return found;
}

std::vector<Plot> kernel_of(Simulation& simulation, Index i) {
  return look_inside(simulation, i, true).kernel;
}

Simulation still_water(const char* density = "continuity") {
  return Simulation(stage4::stage().scene("still_water"), typed({{"spacing", 0.05}, {"density", density}}));
}

}  // namespace

TEST_CASE("of a disc that falls, the forces are its weight and its drag, and their sum is m a", "[inside]") {
  Simulation drop(stage1::stage().scene("drop"));
  for (int k = 0; k < 20; ++k) drop.step();
  const auto seen = look_inside(drop, 0);
  const double m = drop.particles().mass(0), g = drop.parameters().value("gravity");
  CHECK(force_of(seen, "gravity") == Vector{0, -m * g});
  const Vector v = velocity(drop);
  CHECK(force_of(seen, "drag").y == Approx(-drop.parameters().value("drag") * v.y).epsilon(1e-12));
  CHECK(force_of(seen, "wall") == Vector{0, 0});
  CHECK(seen.forces.back().force.y == Approx(-m * g - drop.parameters().value("drag") * v.y).epsilon(1e-12));
  CHECK(seen.support == 0);
  CHECK(seen.neighbours.empty());
}

TEST_CASE("a floor bears the weight of a disc that rests on it, and not of one that passes by", "[inside]") {
  Simulation disc(stage2::stage().scene("cloud"), typed({{"particles", 1.0}}));
  auto& s = disc.system();
  const double floor = disc.model().walls()->bottom;
  s.position.row(0) << 200, floor;
  s.velocity.setZero();
  const auto rests = look_inside(disc, 0);
  CHECK(force_of(rests, "wall").y == -force_of(rests, "gravity").y);
  CHECK(norm(rests.forces.back().force) == 0);
  s.velocity(0, 1) = 50;
  CHECK(norm(force_of(look_inside(disc, 0), "wall")) == 0);
  s.velocity(0, 1) = 0;
  s.position(0, 1) = floor + 1;
  CHECK(norm(force_of(look_inside(disc, 0), "wall")) == 0);
}

TEST_CASE("with all pairs everybody is tested, with the grid only those in the cells around", "[inside]") {
  Simulation pairs(stage2::stage().scene("cloud")), grid(stage3::stage().scene("cloud"));
  const auto of_pairs = look_inside(pairs, 7), of_grid = look_inside(grid, 7);
  CHECK(of_pairs.neighbours == of_grid.neighbours);
  CHECK(of_pairs.in_vain.size() + of_pairs.neighbours.size() == 499);
  CHECK(of_grid.in_vain.size() < 30);
  CHECK(of_pairs.visited.low == of_pairs.visited.high);
  CHECK(of_grid.visited.high.x > of_grid.visited.low.x);
  for (const auto j : of_grid.in_vain)
    CHECK(std::ranges::find(of_grid.neighbours, j) == of_grid.neighbours.end());
}

TEST_CASE("no two forces of a scene share a colour, and pressure has the same one everywhere", "[inside]") {
  std::set<std::tuple<float, float, float>> of_pressure;
  for (const auto& stage : {stage1::stage(), stage2::stage(), stage4::stage(), stage5::stage()})
    for (const auto& scene : stage.scenes) {
      CAPTURE(stage.name, scene.name);
      Simulation simulation(scene);
      const auto seen = look_inside(simulation, 0);
      std::set<std::tuple<float, float, float>> colours;
      for (const auto& force : seen.forces) {
        const auto [r, g, b, opacity] = force.colour;
        CHECK(colours.insert({r, g, b}).second);
        if (force.law == "pressure") of_pressure.insert({r, g, b});
        CHECK(force.law.find('_') == std::string::npos);  // each law has a name that a person reads
      }
    }
  CHECK(of_pressure.size() == 1);
}

TEST_CASE("the table says each force with the scene's unit, in the colour of its arrow", "[inside]") {
  auto water = still_water();
  const auto seen = look_inside(water, particle_at(water, 0.5, 0.5));
  const auto first = seen.facts.size() - seen.forces.size();
  for (std::size_t k = 0; k < seen.forces.size(); ++k) {
    CHECK(seen.facts[first + k].colour == seen.forces[k].colour);
    CHECK(seen.facts[first + k].value.ends_with(" N/m"));
  }
  CHECK(seen.facts[0].value.ends_with(" m"));
  CHECK(seen.facts[2].value.ends_with(" m/s"));
}

TEST_CASE("all arrows have one scale, and the longest force fits it", "[inside]") {
  auto water = still_water();
  Viewpoint viewpoint;
  const Index i = particle_at(water, 0.3, 0.02);
  viewpoint.chosen = water.particles().id(i);
  auto picture = describe("stage", water, viewpoint);
  double largest = 0;
  for (const auto& force : picture.chosen->forces) largest = std::max(largest, norm(force.force));
  CHECK(picture.chosen->full_force >= largest);
  CHECK(picture.chosen->full_force <= 1.7 * largest);
  const auto length_of_weight = [&] {
    RecordingCanvas canvas;
    const auto view = fit(picture, {{0, 0}, {1280, 720}});
    Painter().paint(canvas, picture, view);
    const Point at = view.to_pixel(picture.x[i], picture.y[i]);
    double length = 0;
    for (const auto& line : canvas.lines)
      if (line.size() == 2 && line[0] == at && line[1].y > at.y) length = std::max(length, line[1].y - at.y);
    return length;
  };
  const double length = length_of_weight();
  CHECK(length > 5);
  picture.chosen->full_force *= 2;
  CHECK(length_of_weight() == Approx(length / 2));
}

TEST_CASE("inside still water V W sums to 1 and V grad W to 0, at its surface much is missing", "[inside]") {
  auto water = still_water();
  const auto bulk = kernel_of(water, particle_at(water, 0.5, 0.5));
  const auto surface = kernel_of(water, particle_at(water, 0.5, 2));
  REQUIRE(bulk.size() == 3);
  CHECK(end_of(bulk[1]) == Approx(1).epsilon(0.01));
  CHECK(end_of(surface[1]) > 0.5);
  CHECK(end_of(surface[1]) < 0.75);
  const auto gradient = [](const Plot& plot) {
    return std::stod(plot.y_label.substr(plot.y_label.find('=') + 1));
  };
  CHECK(gradient(bulk[2]) < 0.01);
  CHECK(gradient(surface[2]) > 0.5);
}

TEST_CASE("beside a wall its particles stand in for the liquid that is missing", "[inside]") {
  auto water = still_water();
  const Index i = particle_at(water, 0.5, 0);
  const auto plots = kernel_of(water, i);
  REQUIRE(plots[0].bars.size() == 2);
  CHECK(plots[0].bars[1].xs.size() == look_inside(water, i).walls.size());
  CHECK(end_of(plots[1]) == Approx(1).epsilon(0.01));
  CHECK(kernel_of(water, particle_at(water, 0.5, 0.5))[0].bars.size() == 1);
}

TEST_CASE("bars end on the curve of the kernel as far as the liquid is not compressed", "[inside]") {
  auto water = still_water();
  const auto plots = kernel_of(water, particle_at(water, 0.5, 0.5));
  for (const auto& plot : {plots[0], plots[2]}) {
    const auto& curve = plot.curves.back();
    for (std::size_t k = 0; k < plot.bars[0].xs.size(); ++k) {
      const double x = plot.bars[0].xs[k];
      const auto at = std::ranges::lower_bound(curve.xs, x) - curve.xs.begin();
      const auto here = static_cast<std::size_t>(at);
      CHECK(plot.bars[0].ys[k] == Approx(curve.ys[here]).margin(0.02));
    }
  }
}

TEST_CASE("where the density is a sum, it is the one that the kernel shows", "[inside]") {
  auto water = still_water("summation");
  water.step();
  const Index i = particle_at(water, 0.5, 2);
  const auto sum = kernel_of(water, i)[1];
  const auto density = fmt::format("{:.1f}", water.particles().density(i));
  CHECK(sum.curves[2].label.find(density) != std::string::npos);
  CHECK(sum.curves[0].label.find(density) != std::string::npos);
}

TEST_CASE("two discs that are pressed together are a bar on the law of contact", "[inside]") {
  Simulation pair(stage2::stage().scene("pair"));
  const double h = pair.parameters().value("radius"), k = pair.parameters().value("stiffness");
  pair.system().position.row(1) = pair.system().position.row(0);
  pair.system().position(1, 0) += 1.5 * h;
  const auto plots = kernel_of(pair, 0);
  REQUIRE(plots.size() == 1);
  REQUIRE(plots[0].bars[0].xs.size() == 1);
  CHECK(plots[0].bars[0].xs[0] == Approx(1.5 * h));
  CHECK(plots[0].bars[0].ys[0] == Approx(0.5 * h * k));
  Simulation drop(stage1::stage().scene("drop"));
  CHECK(kernel_of(drop, 0).empty());
}

TEST_CASE("bars are painted between zero and their value, and named in the key", "[plots]") {
  Plot plot{.title = "W", .x_label = "r/h", .y_label = {}, .curves = {}};
  plot.bars = {{.label = "liquid", .xs = {0.5, 1.5}, .ys = {2, 1}}};
  RecordingCanvas canvas;
  paint(canvas, plot, {{0, 0}, {600, 300}});
  const auto dots =
      std::ranges::find_if(canvas.disc_calls, [](const auto& call) { return call.size() == 2; });
  REQUIRE(dots != canvas.disc_calls.end());
  CHECK((*dots)[0].centre.y < (*dots)[1].centre.y);
  CHECK(std::ranges::any_of(canvas.texts, [](const auto& text) { return text.words == "liquid"; }));
  plot.bars[0].ys.pop_back();
  CHECK_THROWS_AS(paint(canvas, plot, {{0, 0}, {600, 300}}), std::invalid_argument);
}
