#include "common/runner/describe_inside.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "common/laws/walls.hpp"
#include "common/runner/colour_range.hpp"
#include "common/runner/describe.hpp"
#include "common/runner/ink.hpp"
#include "common/runner/units.hpp"
#include "common/words.hpp"

namespace clapotis {
namespace {

/// With as many digits whatever the value, so that a table of them stands still.
std::string steady(double value, int digits = 4) {
  auto text = fmt::format("{:#.{}g}", value == 0 ? 0.0 : value, digits);
  if (text.back() == '.') text.pop_back();
  for (const auto& [printed, read] : {std::pair{"e+0", "e"}, {"e-0", "e-"}, {"e+", "e"}})
    if (const auto at = text.find(printed); at != std::string::npos)
      text.replace(at, std::string_view(printed).size(), read);
  return text;
}

std::string steady(const Vector& v) { return fmt::format("({}, {})", steady(v.x), steady(v.y)); }

/// What the walls bear of the acceleration of a particle that rests on them: one that is at a wall, is
/// pressed against it, and could not leave it within a step.
Vector borne_by(const Walls& walls, const Vector& r, const Vector& v, const Vector& a, double dt) {
  const auto along = [&](double x, double speed, double pressing, double low, double high) {
    const bool rests = (x <= low && pressing < 0) || (x >= high && pressing > 0);
    return rests && std::abs(speed) <= std::abs(pressing) * dt ? -pressing : 0.0;
  };
  return {along(r.x, v.x, a.x, walls.left, walls.right), along(r.y, v.y, a.y, walls.bottom, walls.top)};
}

/// The forces, law by law, and at the end their sum.
std::vector<ForceArrow> forces_on(const Simulation& simulation, const std::vector<ActingLaw>& laws, Index i) {
  const auto& p = simulation.particles();
  const double m = p.mass(i);
  Vector sum{0, 0};
  std::vector<ForceArrow> forces;
  const auto add = [&](std::string_view law, const Vector& a) {
    forces.push_back({std::string(called(law, Naming::law)), m * a, law_colour(law, forces)});
    sum += a;
  };
  for (const auto& [law, a] : laws) add(law, a);
  const auto walls = simulation.model().walls();
  if (walls && simulation.model().wall_particles() == nullptr)
    add("walls", borne_by(*walls, row(p.position, i), row(p.velocity, i), sum, simulation.dt()));
  forces.push_back({std::string(words().window.inside.sum), m * sum, ink::text});
  return forces;
}

void add_values(Chosen& chosen, const Simulation& simulation, const Vector& acceleration) {
  const auto& w = words().window;
  const auto& p = simulation.particles();
  const auto i = chosen.particle;
  const auto& length = simulation.scene().length_unit;
  const auto add = [&](std::string_view name, const std::string& value, std::string_view unit) {
    chosen.facts.push_back({std::string(name), value + " " + printed(short_unit(unit, length))});
  };
  const Vector v = row(p.velocity, i);
  add(w.position, steady(row(p.position, i)), "L");
  add(w.velocity, steady(v), "L/s");
  add(w.speed_of_particle, steady(norm(v)), "L/s");
  add(w.acceleration, steady(acceleration), "L/s^2");
  add(w.inside.mass, steady(p.mass(i)), simulation.setup().fluid ? "kg/L" : "kg");
  for (const auto& column : p.columns()) {
    const int digits = column.name == "density" ? 6 : 4;  // a liquid's changes by one in a thousand
    if (column.name != "mass") add(symbol(column.name), steady(column.values(i), digits), column.unit);
  }
}

void add_forces(Chosen& chosen, const Simulation& simulation) {
  chosen.force_unit = printed(short_force_unit(simulation));
  double largest = 0;
  for (const auto& f : chosen.forces) {
    chosen.facts.push_back({f.law, steady(norm(f.force), 3) + " " + chosen.force_unit, f.colour});
    largest = std::max(largest, norm(f.force));
  }
  chosen.full_force = ColourRange{}.follow(0, largest).second;
}

void add_neighbours(Chosen& chosen, Simulation& simulation) {
  const auto& w = words().window;
  const auto near = simulation.model().neighbourhood(simulation.particles(), chosen.particle);
  if (!near) return;
  chosen.support = near->support;
  chosen.visited = near->visited;
  chosen.neighbours = near->neighbours;
  auto left = near->neighbours.begin();  // those of the candidates that are, in their order
  for (const auto j : near->candidates) {
    if (left != near->neighbours.end() && *left == j)
      ++left;
    else
      chosen.in_vain.push_back(j);
  }
  chosen.label = say(w.near, fmt::arg("count", chosen.neighbours.size()));
  if (!chosen.walls.empty())
    chosen.label += ", " + say(w.inside.in_walls, fmt::arg("count", chosen.walls.size()));
  chosen.in_vain_label = say(w.inside.in_vain, fmt::arg("count", chosen.in_vain.size()));
}

}  // namespace

Chosen look_inside(Simulation& simulation, Index particle, bool with_kernel) {
  Chosen chosen{.particle = particle, .neighbours = {}, .label = {}};
  std::vector<ActingLaw> laws;
  const Vector r = row(simulation.particles().position, particle);
  simulation.look([&](const System& s) {
    laws = s.model.accelerations_by_law(s, particle);
    if (const auto kernel = s.model.kernel_around(particle))
      for (const auto& other : kernel->neighbours)
        if (other.wall) chosen.walls.push_back(r - other.separation);
    if (with_kernel) chosen.kernel = kernel_plots(simulation, s, particle);
  });
  add_neighbours(chosen, simulation);
  chosen.forces = forces_on(simulation, laws, particle);
  add_values(chosen, simulation, 1 / simulation.particles().mass(particle) * chosen.forces.back().force);
  add_forces(chosen, simulation);
  const bool acts = std::ranges::any_of(laws, [](const auto& law) { return norm(law.acceleration) > 0; });
  const bool held = simulation.model().has_open_ends() && !acts;
  chosen.title = say(held ? words().window.inside.held : words().window.particle,
                     fmt::arg("id", simulation.particles().id(particle)));
  return chosen;
}

}  // namespace clapotis
