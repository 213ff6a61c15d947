#include "common/simulation/tools.hpp"

#include <cmath>
#include <vector>

#include "common/laws/dummy_walls.hpp"
#include "common/laws/hand.hpp"
#include "common/simulation/errors.hpp"
#include "common/words.hpp"

namespace clapotis {
namespace {

constexpr double close = 0.9;  // spacings: nearer than this to anything, there is no room for a particle

Vectors to_array(const std::vector<Vector>& all) {
  Vectors places(static_cast<Index>(all.size()), 2);
  for (Index i = 0; i < places.rows(); ++i)
    places.row(i) << all[static_cast<std::size_t>(i)].x, all[static_cast<std::size_t>(i)].y;
  return places;
}

/// Whether one of the places is nearer to r than `distance`.
bool any_near(const Vectors& places, const Vector& r, double distance) {
  return places.rows() > 0 &&
         ((places.col(0) - r.x).square() + (places.col(1) - r.y).square()).minCoeff() < distance * distance;
}

/// The points of the lattice whose cells have a corner at the origin, within a disc: walls and blocks of
/// liquid stand on it.
std::vector<Vector> lattice_disc(const Vector& at, double radius, double dx) {
  std::vector<Vector> points;
  const auto first = [&](double x) { return (std::floor((x - radius) / dx) + 0.5) * dx; };
  for (double y = first(at.y); y <= at.y + radius; y += dx)
    for (double x = first(at.x); x <= at.x + radius; x += dx)
      if (norm(Vector{x, y} - at) <= radius) points.push_back({x, y});
  return points;
}

/// Those of the walls' particles, obstacles included.
Vectors wall_places(const Simulation& simulation) {
  const auto* walls = simulation.model().wall_particles();
  return walls != nullptr ? walls->places : Vectors(0, 2);
}

[[noreturn]] void refuse(std::string_view sentence, const Vector& at, const Simulation& simulation) {
  throw BadInput(say(sentence, fmt::arg("x", fmt::format("{:.3g}", at.x)),
                     fmt::arg("y", fmt::format("{:.3g}", at.y)),
                     fmt::arg("unit", simulation.scene().length_unit)));
}

}  // namespace

bool has_hand(const Simulation& simulation) { return simulation.model().hand() != nullptr; }

void hold_hand(Simulation& simulation, const Vector& at, double pull) {
  simulation.edit([&](System& s) {
    s.model.hand()->touch.at = at;
    s.model.hand()->touch.pull = pull;
  });
}

void shake_tank(Simulation& simulation, const Vector& acceleration) {
  simulation.edit([&](System& s) { s.model.hand()->touch.shake = acceleration; });
}

void let_go(Simulation& simulation) {
  const auto& touch = simulation.model().hand()->touch;
  if (touch.pull == 0 && norm(touch.shake) == 0) return;
  simulation.edit([](System& s) { s.model.hand()->touch = {}; });
}

void add_drop(Simulation& simulation, const Vector& at, double radius) {
  const double dx = simulation.setup().fluid->spacing;
  const Vectors walls = wall_places(simulation);
  std::vector<Vector> room;
  for (const Vector& r : lattice_disc(at, radius, dx))
    if (simulation.setup().view.contains(r) && !any_near(simulation.particles().position, r, close * dx) &&
        !any_near(walls, r, close * dx))
      room.push_back(r);
  if (room.empty()) refuse(words().no_room_for_drop, at, simulation);
  simulation.edit([&](System& s) {
    auto& p = s.particles;
    const auto count = static_cast<Index>(room.size());
    const Index first = p.append(count);
    p.position.middleRows(first, count) = to_array(room);
    p.density.segment(first, count) = simulation.setup().fluid->state.reference_density;
  });
}

void erase(Simulation& simulation, const Vector& at, double radius) {
  const auto far = [&](const Vector& r) { return norm(r - at) > radius; };
  simulation.edit([&](System& s) {
    std::vector<char> stays;
    for (Index i = 0; i < s.particles.size(); ++i) stays.push_back(far(row(s.position, i)) ? 1 : 0);
    s.particles.keep(stays);
    const auto& obstacles = s.model.obstacles();
    std::vector<Vector> left;
    for (Index k = 0; k < obstacles.rows(); ++k)
      if (far(row(obstacles, k))) left.push_back(row(obstacles, k));
    if (static_cast<Index>(left.size()) < obstacles.rows()) s.model.put_obstacles(to_array(left));
  });
}

void draw_obstacle(Simulation& simulation, const Vector& at, double radius) {
  const double dx = simulation.setup().fluid->spacing;
  if (any_near(simulation.particles().position, at, radius + close * dx))
    refuse(words().obstacle_over_liquid, at, simulation);
  const Vectors walls = wall_places(simulation);
  std::vector<Vector> fresh;
  for (const Vector& r : lattice_disc(at, radius, dx))
    if (!any_near(walls, r, close * dx)) fresh.push_back(r);
  if (fresh.empty()) return;  // an obstacle is there already
  simulation.edit([&](System& s) {
    const Vectors before = s.model.obstacles();
    Vectors all(before.rows() + static_cast<Index>(fresh.size()), 2);
    all << before, to_array(fresh);
    s.model.put_obstacles(all);
  });
}

}  // namespace clapotis
