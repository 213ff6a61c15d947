#include "common/window/sight.hpp"

#include <algorithm>
#include <cmath>

namespace clapotis {
namespace {

constexpr double closest = 200, farthest = 0.2;  // zoom

struct Near {
  Index particle = 0;
  double distance = 0;
};

/// Of at least one.
Near nearest(const Particles& p, const Eigen::Vector2d& at) {
  Near found;
  found.distance = std::sqrt(((p.position.col(0) - at.x()).square() + (p.position.col(1) - at.y()).square())
                                 .minCoeff(&found.particle));
  return found;
}

}  // namespace

void Sight::look_at_other_scene(const Simulation& simulation) {
  viewpoint.colour_by = simulation.setup().colour_by;
  viewpoint.chosen.reset();
  tank.setZero();
  colour_range = arrow_range = force_range = {};
  viewpoint.kernel = false;
  show_whole_scene();
}

void Sight::colour_by(const std::string& quantity) {
  viewpoint.colour_by = quantity;
  colour_range = {};
}

void Sight::next_colouring(const Simulation& simulation) {
  const auto all = colourings(simulation);
  const auto now = std::find(all.begin(), all.end(), viewpoint.colour_by);
  colour_by(now == all.end() || now + 1 == all.end() ? all.front() : *(now + 1));
}

void Sight::select_next(const Simulation& simulation, int direction) {
  const auto& particles = simulation.particles();
  const Index n = particles.size();
  if (n == 0) return;
  const auto now = viewpoint.chosen ? particles.place_of(*viewpoint.chosen) : std::nullopt;
  const Index first = direction > 0 ? 0 : n - 1;
  viewpoint.chosen = particles.id(now ? (*now + direction + n) % n : first);
}

void Sight::select_middle(const Simulation& simulation) {
  const auto& p = simulation.particles();
  viewpoint.chosen.reset();
  if (p.size() == 0) return;
  viewpoint.chosen = p.id(nearest(p, p.position.colwise().mean().matrix().transpose()).particle);
}

void Sight::select_at(const Simulation& simulation, const PictureView& view, Point pixel, double reach) {
  const auto& p = simulation.particles();
  viewpoint.chosen.reset();
  if (p.size() == 0) return;
  const auto [particle, distance] = nearest(p, view.to_world(pixel));
  if (distance <= simulation.setup().radius + reach / view.pixels_per_unit) viewpoint.chosen = p.id(particle);
}

PictureView Sight::view(const Picture& picture, const Box& area, double scale) const {
  auto view = fit(picture, area, scale);
  view.pixels_per_unit *= zoom;
  view.centre += moved - tank;
  return view;
}

void Sight::zoom_at(const PictureView& view, Point pixel, double factor) {
  const double before = zoom;
  zoom = std::clamp(zoom * factor, farthest, closest);
  // The world below the mouse lies (at - centre) from the middle; that distance on the screen must not
  // change.
  moved += (view.to_world(pixel) - view.centre) * (1 - before / zoom);
}

void Sight::move_by(const PictureView& view, Point pixels) {
  moved += Eigen::Vector2d(-pixels.x, pixels.y) / view.pixels_per_unit;
}

void Sight::show_whole_scene() {
  zoom = 1;
  moved.setZero();
}

}  // namespace clapotis
