#include <fmt/core.h>

#include <algorithm>
#include <cmath>

#include "report/bench/timed.hpp"
#include "stage4_sph/scenes.hpp"

namespace clapotis::bench {
namespace {

/// The dam break with about `count` particles of fluid, cubic spline and h/dx = 1.3, flowing for a while
/// already.
std::unique_ptr<Simulation> flowing_dam_break(long count, int threads = 1, const Overrides& more = {}) {
  const double columns = std::round(std::sqrt(static_cast<double>(count) / 2));
  Overrides overrides{
      {"kernel", {"cubic_spline"}}, {"h_over_dx", {"1.3"}}, {"spacing", {to_text(1 / columns)}}};
  for (const auto& [name, value] : more) overrides.insert_or_assign(name, value);
  auto simulation = std::make_unique<Simulation>(stage4::stage().scene("dam_break"), overrides,
                                                 default_integrator, threads);
  for (int step = 0; step < 64; ++step) simulation->step();
  return simulation;
}

double million_updates(const Simulation& simulation, double seconds) {
  return 1e-6 * static_cast<double>(simulation.particles().size()) / seconds;
}

void print_where_it_goes(const Cost& before, const Cost& after) {
  const double sum = after.neighbours - before.neighbours + after.density - before.density + after.forces -
                     before.forces + after.integration - before.integration + after.walls - before.walls;
  const auto share = [&](double from, double to) { return 100 * (to - from) / sum; };
  fmt::print(
      "  of it: sorting {:.0f} %, density {:.0f} %, acceleration {:.0f} %, integration {:.0f} %, walls "
      "{:.0f} %\n",
      share(before.neighbours, after.neighbours), share(before.density, after.density),
      share(before.forces, after.forces), share(before.integration, after.integration),
      share(before.walls, after.walls));
}

}  // namespace

TEST_CASE("dam break of 20,000 particles, one core: everything in a step counted", "[sph]") {
  auto simulation = flowing_dam_break(20000);
  const auto pairs = simulation->model().count_pairs(simulation->particles());
  const auto n = static_cast<double>(simulation->particles().size());
  const auto before = simulation->cost();
  const double seconds = step_seconds("a step of 20000 particles", *simulation);
  const double near = static_cast<double>(pairs.neighbours) / n,
               tested = static_cast<double>(pairs.candidates) / n;
  fmt::print(
      "\ndam_break, {:.0f} particles of fluid: {:.2f} M updates/s, {:.1f} neighbours of {:.1f} candidates "
      "each, vectors "
      "of {}, {:.0f} bytes per particle\n",
      n, million_updates(*simulation, seconds), near, tested, pack_width, simulation->bytes_per_particle());
  print_where_it_goes(before, simulation->cost());
}

TEST_CASE("what a particle costs does not grow with their number", "[sph][scaling]") {
  double least = 1e300, most = 0;
  std::vector<std::string> lines;
  for (const long count : {2000L, 20000L, 200000L}) {
    auto simulation = flowing_dam_break(count);
    const double seconds = step_seconds(fmt::format("a step of {} particles", count), *simulation);
    const double rate = million_updates(*simulation, seconds);
    least = std::min(least, rate);
    most = std::max(most, rate);
    lines.push_back(fmt::format("{:>9} particles: {:.2f} M updates/s, {:.0f} bytes each",
                                simulation->particles().size(), rate, simulation->bytes_per_particle()));
  }
  fmt::print("\n");
  for (const auto& line : lines) fmt::print("{}\n", line);
  fmt::print("slowest over fastest: {:.2f}\n", least / most);
}

TEST_CASE("dam break: two threads against one", "[sph][threads]") {
  for (const long count : {2000L, 20000L, 200000L}) {
    auto one = flowing_dam_break(count), two = flowing_dam_break(count, 2);
    fmt::print("dam_break, {} particles: two threads are {:.2f} times one\n", one->particles().size(),
               times_as_fast(*two, *one));
  }
}

TEST_CASE("what a choice costs: kernels, density, viscosity", "[sph][choices]") {
  std::vector<std::string> lines;
  const std::vector<std::pair<std::string, Overrides>> choices{
      {"cubic_spline 1.3, continuity", {}},
      {"wendland_c2 1.5", {{"kernel", {"wendland_c2"}}, {"h_over_dx", {"1.5"}}}},
      {"wendland_c2 2", {{"kernel", {"wendland_c2"}}, {"h_over_dx", {"2"}}}},
      {"density = summation", {{"density", {"summation"}}}},
      {"walls = reflect", {{"walls", {"reflect"}}}},
      {"nu = 1e-3", {{"nu", {"1e-3"}}}}};
  for (const auto& [name, overrides] : choices) {
    auto simulation = flowing_dam_break(20000, 1, overrides);
    const double seconds = step_seconds(name, *simulation);
    lines.push_back(fmt::format("{:<32} {:>7.1f} ns per particle and step, dt = {:.3g} s, {:.1f} bytes", name,
                                1e3 / million_updates(*simulation, seconds), simulation->dt(),
                                simulation->bytes_per_particle()));
  }
  fmt::print("\n");
  for (const auto& line : lines) fmt::print("{}\n", line);
}

}  // namespace clapotis::bench
