#pragma once

#include <cmath>

#include "common/laws/air_drag.hpp"
#include "common/laws/contact_spring.hpp"
#include "common/laws/gravity.hpp"
#include "common/laws/walls.hpp"
#include "common/particles/shapes.hpp"
#include "common/simulation/fused_model.hpp"
#include "common/simulation/quantities.hpp"
#include "common/simulation/scene.hpp"
#include "stage2_cloud/closed_forms.hpp"

namespace clapotis::stage2 {

inline const Parameter particle_count{.name = "particles",
                                      .symbol = "N",
                                      .unit = "",
                                      .value = 500,
                                      .range = {.low = 1, .high = 1e8},
                                      .change = Change::restart};
inline const Parameter placement_seed{.name = "seed",
                                      .symbol = "",
                                      .unit = "",
                                      .value = 1,
                                      .range = {.low = 0, .high = 0x1p53},
                                      .change = Change::restart};
inline const Parameter mass_ratio{.name = "mass_ratio",
                                  .symbol = "m2/m1",
                                  .unit = "",
                                  .value = 1,
                                  .range = positive,
                                  .change = Change::restart};

/// The laws of a cloud of discs; `Search` is how they find each other.
template <class Search, class Mass = UniformMass>
using CloudModel = FusedModel<Search, Mass, Gravity, AirDrag, ContactSpring, SupportingWalls>;

inline View2D whole_box(Parameters& p) { return {0, p.number(box_width), 0, p.number(box_height)}; }

/// The box, its laws and no discs yet: a scene first asks whether they fit.
template <class Search>
Setup empty_box(Parameters& p) {
  return {.particles = Particles(0, p.number(disc_mass)),
          .model = std::make_unique<CloudModel<Search>>(p),
          .radius = p.number(disc_radius),
          .view = whole_box(p)};
}

/// N discs, placed at random above (x0, y0) without touching, fall with the velocity (vx0, vy0) in the box.
template <class Search>
Setup cloud(Parameters& p) {
  const Index n = p.integer(particle_count);
  auto setup = empty_box<Search>(p);
  const Walls walls = *setup.model->walls();
  require_inside(p, walls, setup.radius);
  const double left = std::max(p.number(start_x) + setup.radius, walls.left);
  const double bottom = std::max(p.number(start_y) + setup.radius, walls.bottom);
  const Vectors places =
      scattered_discs(n, setup.radius, {left, walls.right, bottom, walls.top},
                      static_cast<std::uint64_t>(p.integer(placement_seed)), p.length_unit());
  setup.particles = Particles(n, setup.particles.uniform_mass);
  setup.particles.position = places;
  setup.particles.velocity.col(0) = p.number(start_vx);
  setup.particles.velocity.col(1) = p.number(start_vy);
  return setup;
}

/// Two discs, the first at (x0, y0) with velocity (vx0, vy0), the second its mirror image, meet head-on.
template <class Search>
Setup pair(Parameters& p) {
  Setup setup{.particles = Particles(2, p.number(disc_mass)),
              .model = nullptr,
              .radius = p.number(disc_radius),
              .view = whole_box(p)};
  const double m = p.number(disc_mass), x = p.number(start_x), y = p.number(start_y);
  const double vx = p.number(start_vx), vy = p.number(start_vy);
  const double width = p.number(box_width), ratio = p.number(mass_ratio);
  setup.particles.add_column("mass", "kg") << m, ratio * m;
  setup.particles.position << x, y, width - x, y;
  setup.particles.velocity << vx, vy, -vx, vy;
  setup.model = std::make_unique<CloudModel<Search, StoredMass>>(p);
  require_inside(p, *setup.model->walls());
  setup.reference = head_on_collision(p, setup.particles, *setup.model->walls());
  return setup;
}

/// N discs in a column on the floor, just touching; their weight presses them together, drag lets them come
/// to rest.
template <class Search>
Setup stack(Parameters& p) {
  const Index n = p.integer(particle_count);
  auto setup = empty_box<Search>(p);
  require_height(p, n, setup.radius);
  setup.particles = Particles(n, setup.particles.uniform_mass);
  setup.particles.position.col(0) = p.number(box_width) / 2;
  setup.particles.position.col(1) =
      setup.radius * (1 + 2 * Column::LinSpaced(n, 0, static_cast<double>(n - 1)));
  setup.reference = column_at_rest(p, n);
  return setup;
}

template <class Search>
std::vector<Scene> cloud_scenes() {
  return {{.name = "cloud",
           .length_unit = "px",
           .defaults = {{"gravity", "500"}, {"drag", "0.1"}, {"y0", "200"}},
           .build = cloud<Search>,
           .presets = {{"gas", {{"gravity", "0"}, {"drag", "0"}, {"restitution", "1"}, {"y0", "0"}}},
                       {"crowd", {{"particles", "1500"}, {"radius", "6"}, {"y0", "0"}}}}},
          {.name = "pair",
           .length_unit = "px",
           .defaults = {{"gravity", "0"}, {"x0", "200"}, {"y0", "300"}, {"vx0", "200"}, {"restitution", "1"}},
           .build = pair<Search>},
          {.name = "stack",
           .length_unit = "px",
           .defaults = {{"gravity", "500"}, {"drag", "50"}, {"particles", "10"}},
           .build = stack<Search>}};
}

}  // namespace clapotis::stage2
