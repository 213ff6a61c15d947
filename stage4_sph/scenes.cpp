#include "stage4_sph/scenes.hpp"

#include <cmath>

#include "common/laws/gravity.hpp"
#include "common/references/dam_break_front.hpp"
#include "common/references/elliptical_drop.hpp"
#include "common/references/hydrostatic.hpp"
#include "common/references/released_column.hpp"
#include "common/references/square_patch.hpp"
#include "stage4_sph/handout.hpp"
#include "stage4_sph/liquid.hpp"
#include "stage4_sph/parameters.hpp"
#include "stage4_sph/references.hpp"

namespace clapotis::stage4 {
namespace {

/// A column of water, a wide and H high, in the left corner of a tank; the gate before it is gone at t = 0.
Setup dam_break(Parameters& p) {
  const double a = p.number(column_width), height = p.number(column_height);
  const double g = Gravity::from(p).g;
  const Fluid fluid = liquid(p, std::sqrt(2 * g * height));
  auto tank = stage4::tank(p, fluid);
  require_inside_tank(p, tank, {column_width, column_height});
  Setup setup{.particles = particles_at(block(fluid.spacing, 0, a, 0, height), p),
              .model = tank_model(p, std::move(tank.walls)),
              .radius = fluid.spacing / 2,
              .view = {0, tank.width, 0, tank.height},
              .fluid = fluid,
              .measures = {front(fluid.spacing)}};
  if (std::abs(height - 2 * a) < 1e-9 * a)  // that of the experiments
    setup.reference = dam_break_experiment(front(fluid.spacing), a, g);
  const ReleasedColumn start{a, height, fluid.state.reference_density, g};
  for (Index i = 0; i < setup.particles.size(); ++i)
    setup.particles.density(i) =
        fluid.state.density(start.pressure(setup.particles.position(i, 0), setup.particles.position(i, 1)));
  return setup;
}

/// Water at rest in a tank: it is to stay so.
Setup still_water(Parameters& p) {
  const double height = p.number(depth), g = Gravity::from(p).g;
  const Fluid fluid = liquid(p, std::sqrt(2 * g * height));
  auto tank = stage4::tank(p, fluid);
  require_inside_tank(p, tank, {depth});
  Setup setup{.particles = particles_at(block(fluid.spacing, 0, tank.width, 0, height), p),
              .model = tank_model(p, std::move(tank.walls)),
              .radius = fluid.spacing / 2,
              .view = {0, tank.width, 0, tank.height},
              .reference = hydrostatic_pressure(at_rest(p), height, tank.width),
              .fluid = fluid,
              .colour_by = "pressure"};
  rest_under_weight(setup.particles, p, height);
  return setup;
}

/// A round drop whose two halves fly apart along y, without weight: it becomes an ever longer ellipse.
/// Monaghan 1994.
Setup elliptical_drop(Parameters& p) {
  const double radius = p.number(drop_radius), rate = p.number(strain_rate);
  const Fluid fluid = liquid(p, 1.4 * rate * radius);
  Setup setup{.particles = particles_at(disc(fluid.spacing, {0, 0}, radius), p),
              .model = free_model(p),
              .radius = fluid.spacing / 2,
              .view = {-1.6 * radius, 1.6 * radius, -2.2 * radius, 2.2 * radius},
              .fluid = fluid};
  const EllipticalDrop exact{.radius = radius, .strain_rate = rate, .density = fluid.state.reference_density};
  setup.measures = stretches(setup.particles.position);
  setup.reference = ellipse(setup.measures, exact);
  const auto start = exact.at(0);
  for (Index i = 0; i < setup.particles.size(); ++i)
    setup.particles.density(i) =
        fluid.state.density(start.pressure(setup.particles.position(i, 0), setup.particles.position(i, 1)));
  setup.particles.velocity.col(0) = -rate * setup.particles.position.col(0);
  setup.particles.velocity.col(1) = rate * setup.particles.position.col(1);
  return setup;
}

/// A round drop falls on water at rest.
Setup drop_impact(Parameters& p) {
  const double radius = p.number(drop_radius), height = p.number(depth), g = Gravity::from(p).g;
  const double speed = p.number(impact_speed), above = p.number(drop_height);
  const Fluid fluid = liquid(p, std::sqrt(speed * speed + 2 * g * (height + above)));
  auto tank = stage4::tank(p, fluid);
  require_inside_tank(p, tank, {depth});
  const Vector centre{tank.width / 2, height + above + radius};
  const Vectors pool = block(fluid.spacing, 0, tank.width, 0, height);
  const Vectors drop = disc(fluid.spacing, centre, radius);
  Vectors places(pool.rows() + drop.rows(), 2);
  places << pool, drop;
  Setup setup{.particles = particles_at(places, p),
              .model = tank_model(p, std::move(tank.walls)),
              .radius = fluid.spacing / 2,
              .view = {0, tank.width, 0, tank.height},
              .fluid = fluid};
  rest_under_weight(setup.particles, p, height);
  setup.particles.position.bottomRows(drop.rows()) = drop;
  setup.particles.density.tail(drop.rows()) = fluid.state.reference_density;
  setup.particles.velocity.col(1).tail(drop.rows()) = -speed;
  return setup;
}

/// A square of liquid that turns like a rigid body and has no pressure at first: its corners fly out while
/// its middle is under tension. Colagrossi 2005.
Setup square_patch(Parameters& p) {
  const double side = p.number(patch_side), omega = p.number(angular_speed);
  p.number({.name = "epsilon", .symbol = "epsilon", .unit = "", .value = 0.2, .range = not_negative});
  const Fluid fluid = liquid(p, omega * side / std::sqrt(2));
  Setup setup{.particles = particles_at(block(fluid.spacing, -side / 2, side / 2, -side / 2, side / 2), p),
              .model = free_model(p),
              .radius = fluid.spacing / 2,
              .view = {-side, side, -side, side},
              .fluid = fluid,
              .measures = {centre_pressure()},
              .colour_by = "pressure"};
  setup.particles.velocity.col(0) = omega * setup.particles.position.col(1);
  setup.particles.velocity.col(1) = -omega * setup.particles.position.col(0);
  return setup;
}

/// A periodic lattice at rest but for a small disturbance, which stays small in a stable step.
Setup acoustic(Parameters& p) {
  const Fluid fluid = liquid(p, 0.1);
  auto at_least_one_support = patch_side;  // a particle would miss images of the others
  at_least_one_support.range = {.low = 2 * fluid.h};
  const double side = p.number(at_least_one_support);
  Setup setup{.particles = particles_at(block(fluid.spacing, 0, side, 0, side), p),
              .model = free_model(p, {.corner = {0, 0}, .length = {side, side}}),
              .radius = fluid.spacing / 2,
              .view = {0, side, 0, side},
              .fluid = fluid};
  disturb(setup.particles.position, p, fluid.spacing);
  return setup;
}

}  // namespace

Stage stage() {
  return {.name = "stage4_sph",
          .title = "Stage 4 - SPH",
          .scenes = {{.name = "dam_break",
                      .length_unit = "m",
                      .defaults = {{"kernel", "wendland_c2"}},
                      .build = dam_break,
                      .presets = {{"coarse", {{"spacing", "0.0625"}}},
                                  {"fine", {{"spacing", "0.02"}}},
                                  {"oil", {{"nu", "0.05"}, {"slip", "no"}}}},
                      .beside = {{"spacing", "0.0625"}}},
                     {.name = "still_water",
                      .length_unit = "m",
                      .defaults = {{"kernel", "wendland_c2"},
                                   {"h_over_dx", "2"},
                                   {"tank_width", "1"},
                                   {"tank_height", "1.5"},
                                   {"spacing", "0.02"}},
                      .build = still_water,
                      .beside = {{"walls", "reflect"}}},
                     {.name = "elliptical_drop",
                      .length_unit = "m",
                      .defaults = {{"density", "summation"}, {"spacing", "0.05"}, {"alpha", "0.008"}},
                      .build = elliptical_drop,
                      .beside = {{"density", "continuity"}}},
                     {.name = "drop_impact",
                      .length_unit = "m",
                      .defaults = {{"kernel", "wendland_c2"},
                                   {"tank_width", "2"},
                                   {"tank_height", "1.5"},
                                   {"depth", "0.5"},
                                   {"radius", "0.15"},
                                   {"spacing", "0.02"}},
                      .build = drop_impact},
                     {.name = "square_patch",
                      .length_unit = "m",
                      .defaults = {{"kernel", "wendland_c2"}, {"tension", "yes"}, {"spacing", "0.02"}},
                      .build = square_patch,
                      .beside = {{"epsilon", "0"}}},
                     {.name = "acoustic",
                      .length_unit = "m",
                      .defaults = {{"kernel", "cubic_spline"},
                                   {"h_over_dx", "1.3"},
                                   {"density", "summation"},
                                   {"tension", "yes"},
                                   {"side", "12"},
                                   {"spacing", "1"},
                                   {"reference_density", "1"},
                                   {"alpha", "0.1"}},
                      .build = acoustic},
                     {.name = "handout",
                      .length_unit = "px",
                      .defaults = {{"gravity", "500"}, {"disturbance", "0.01"}},
                      .build = handout,
                      .beside = {{"formulation", "consistent"}}}}};
}

}  // namespace clapotis::stage4
