#include "stage1_bouncing/scenes.hpp"

#include <cmath>
#include <limits>

#include "common/laws/air_drag.hpp"
#include "common/laws/gravity.hpp"
#include "common/laws/walls.hpp"
#include "common/references/bounce.hpp"
#include "common/simulation/fused_model.hpp"
#include "common/simulation/quantities.hpp"

namespace clapotis::stage1 {
namespace {

const Parameter impacts{
    .name = "impacts", .symbol = "", .unit = "", .change = Change::restart, .choices = {"located", "clamp"}};

/// The particle at (x0, y0) with velocity (vx0, vy0), inside its walls.
template <class Model>
Setup one_particle(Parameters& p, View2D view) {
  Setup setup{.particles = Particles(1, p.number(disc_mass)),
              .model = std::make_unique<Model>(p),
              .radius = p.number(disc_radius),
              .view = view,
              .locate_impacts = p.choice(impacts) == "located"};
  setup.particles.position.row(0) << p.number(start_x), p.number(start_y);
  setup.particles.velocity.row(0) << p.number(start_vx), p.number(start_vy);
  require_inside(p, *setup.model->walls());
  return setup;
}

Setup bounce(Parameters& p) {
  return one_particle<FusedModel<NoPairs, UniformMass, Gravity, AirDrag, BoxWalls>>(
      p, {0, p.number(box_width), 0, p.number(box_height)});
}

/// y'' = -g - y'/tau with tau = m/beta, v+ = -e v-, in closed form; x likewise, between walls it does not
/// reach.
Reference exact_fall(Parameters& p) {
  const double beta = p.value("drag");
  const double tau = beta > 0 ? p.value("mass") / beta : std::numeric_limits<double>::infinity();
  const BouncingBall ball{.height = p.value("y0"),
                          .speed = p.value("vy0"),
                          .gravity = p.value("gravity"),
                          .drag_time = tau,
                          .restitution = p.value("restitution")};
  const double x0 = p.value("x0"), vx0 = p.value("vx0");
  return {.name = "closed form",
          .measure = "|y - y_exact|",
          .unit = p.length_unit(),
          .source = "y'' = -g - y'/tau, v+ = -e v-, solved in closed form between impacts",
          .error = [ball](const System& s) { return std::abs(s.position(0, 1) - ball.at(s.time).y); },
          .positions =
              [=](double t) {
                const double drift = std::isinf(tau) ? t : -tau * std::expm1(-t / tau);
                Vectors r(1, 2);
                r << x0 + vx0 * drift, ball.at(t).y;
                return r;
              }};
}

Setup drop(Parameters& p) {
  const double w = p.number(box_width), h = p.number(box_height), radius = p.number(disc_radius);
  auto setup = one_particle<FusedModel<NoPairs, UniformMass, Gravity, AirDrag, CentreFloor>>(
      p, {-radius, w + radius, -radius, h});
  setup.reference = exact_fall(p);
  return setup;
}

}  // namespace

Stage stage() {
  return {
      .name = "stage1_bouncing",
      .title = "Stage 1 - bouncing",
      .scenes = {
          {.name = "bounce",
           .length_unit = "px",
           .defaults = {{"gravity", "500"}, {"drag", "0.1"}, {"x0", "100"}, {"y0", "500"}, {"vx0", "200"}},
           .build = bounce,
           .presets = {{"moon", {{"gravity", "83"}, {"drag", "0"}}},
                       {"without_loss", {{"drag", "0"}, {"restitution", "1"}}},
                       {"in_oil", {{"drag", "3"}}}}},
          {.name = "drop",
           .length_unit = "m",
           .defaults = {{"radius", "0.05"},
                        {"gravity", "9.81"},
                        {"drag", "1"},
                        {"width", "1.5"},
                        {"height", "1.2"},
                        {"x0", "0.75"},
                        {"y0", "1"}},
           .build = drop}}};
}

}  // namespace clapotis::stage1
