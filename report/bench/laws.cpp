#include <fmt/core.h>

#include "common/laws/air_drag.hpp"
#include "common/laws/contact_spring.hpp"
#include "common/laws/gravity.hpp"
#include "common/neighbours/cell_grid.hpp"
#include "report/bench/timed.hpp"
#include "report/cloud_with.hpp"

namespace clapotis::bench {
namespace {

template <class... Laws>
using Grid = FusedModel<CellGrid, UniformMass, Laws...>;
template <class... Laws>
using Alone = FusedModel<NoPairs, UniformMass, Laws...>;

struct Case {
  Scene scene;
  Overrides zero;
};

}  // namespace

TEST_CASE("a scene pays for the laws it names: absent against present with zero strength", "[laws]") {
  const Overrides no_drag{{"drag", {"0"}}}, no_weight{{"drag", {"0"}}, {"gravity", {"0"}}};
  const std::vector<Case> cases{
      {cloud_with<Alone<Gravity>>("gravity"), {}},
      {cloud_with<Alone<Gravity, AirDrag>>("gravity, drag = 0"), no_drag},
      {cloud_with<Alone<Gravity, AirDrag, BoxWalls>>("gravity, drag = 0, walls"), no_drag},
      {cloud_with<Grid<ContactSpring>>("springs"), {}},
      {cloud_with<Grid<Gravity, ContactSpring>>("springs, gravity = 0"), no_weight},
      {cloud_with<Grid<Gravity, AirDrag, ContactSpring>>("springs, gravity = 0, drag = 0"), no_weight},
      {cloud_with<Grid<Gravity, AirDrag, ContactSpring, BoxWalls>>("springs, gravity = 0, drag = 0, walls"),
       no_weight},
  };
  std::vector<std::string> lines;
  for (const auto& [scene, zero] : cases) {
    auto overrides = zero;
    for (const auto& [name, value] : Overrides{{"particles", {"10000"}},
                                               {"width", {"2300"}},
                                               {"height", {"2300"}},
                                               {"y0", {"0"}},
                                               {"vy0", {"1"}},
                                               {"dt", {"1e-6"}}})
      overrides.insert_or_assign(name, value);
    Simulation simulation(scene, overrides);
    const double seconds = step_seconds(scene.name, simulation);
    lines.push_back(fmt::format("{:<40} {:>10.2f} ns per particle {:>8.1f} bytes per particle", scene.name,
                                1e9 * seconds / 1e4, simulation.bytes_per_particle()));
  }
  fmt::print("\n");
  for (const auto& line : lines) fmt::print("{}\n", line);
}

}  // namespace clapotis::bench
