#include <algorithm>
#include <cmath>

#include "common/laws/contact_spring.hpp"
#include "common/neighbours/all_pairs.hpp"
#include "common/simulation/fused_model.hpp"
#include "report/studies/hard_case.hpp"
#include "report/studies/measured.hpp"

namespace clapotis::studies {
namespace {

bool warned(const Simulation& run, std::string_view of) {
  const auto all = run.warnings();
  return std::any_of(all.begin(), all.end(), [&](const auto& each) { return each.find(of) != each.npos; });
}

bool finite(const Simulation& run) {
  return run.particles().position.allFinite() && run.particles().velocity.allFinite();
}

/// Of an error, so that one that is not there reads 0.
std::string shown(double error) { return error == 0 ? "0" : rounded(error, 2); }

Vectors accelerations(Simulation& run) {
  Vectors a;
  run.look([&](const System& s) { a = s.acceleration; });
  return a;
}

Outcome meet_at_one_point(Effort /*effort*/) {
  bool passed = true;
  double apart = 0, moved = 0;
  for (const char* stage : {"stage2/pair", "stage3/pair"}) {
    const auto text = scene(stage, {{"x0", "400"}, {"vx0", "0"}, {"dt", "1e-4"}});
    const auto discs = simulation(text), again = simulation(text);
    advance_steps(*discs, 200);
    advance_steps(*again, 200);
    const auto& r = discs->particles().position;
    const auto& v = discs->particles().velocity;
    apart = norm(clapotis::row(r, 0) - clapotis::row(r, 1));
    moved = std::max(moved, norm(clapotis::row(v, 0) + clapotis::row(v, 1)) / norm(clapotis::row(v, 0)));
    passed = passed && finite(*discs) && apart > 20 && (r == again->particles().position).all() &&
             warned(*discs, "at one point");
  }
  const auto water = simulation(scene("stage4/dam_break", {{"spacing", "0.1"}}));
  water->edit([](System& s) {
    s.position.row(70) = s.position.row(7);
    s.density(70) = s.density(7);
  });
  const auto a = accelerations(*water);  // equal: the two do not push each other
  const bool equal = (a.row(70) == a.row(7)).all() && warned(*water, "at one point");
  advance_steps(*water, 50);
  passed = passed && moved < 1e-12 && equal && finite(*water);
  return {fmt::format("discs {} px apart after 200 steps; total momentum {} of one disc's; force between the "
                      "particles of liquid {}; all reported",
                      rounded(apart), shown(moved), equal ? "exactly 0" : "not 0"),
          passed};
}

Outcome fly_into_corners(Effort /*effort*/) {
  double worst = 0;
  for (const char* impacts : {"located", "clamp"})
    for (const double side_x : {-1.0, 1.0})
      for (const double side_y : {-1.0, 1.0})
        for (const char* scheme : {"explicit_euler", "symplectic_euler", "velocity_verlet", "rk2", "rk4"}) {
          const auto ball = simulation(scene("stage1/bounce", {{"gravity", "0"},
                                                               {"drag", "0"},
                                                               {"restitution", "0.8"},
                                                               {"x0", to_text(400 + side_x * 290)},
                                                               {"y0", to_text(300 + side_y * 190)},
                                                               {"vx0", to_text(200 * side_x)},
                                                               {"vy0", to_text(200 * side_y)},
                                                               {"dt", "0.2"},
                                                               {"impacts", impacts},
                                                               {"integrator", scheme}}));
          advance_steps(*ball, 3);
          const auto v = clapotis::row(ball->particles().velocity, 0);
          worst = std::max(worst, norm(v - Vector{-160 * side_x, -160 * side_y}) / norm(v));
        }
  return {fmt::format("each wall turned it round once; its velocity is off by {} at most", shown(worst)),
          worst < 1e-12};
}

/// Where a particle that flew from `start` for the path `way` between walls without loss is now.
double folded(double start, double way, double low, double high) {
  const double box = high - low;
  const double unfolded = std::fmod(std::fmod(start - low + way, 2 * box) + 2 * box, 2 * box);
  return unfolded <= box ? low + unfolded : high - (unfolded - box);
}

/// How far from where it should be a disc ends that crosses many boxes in one step, over its path.
double off_the_path(Simulation& disc, const Vector& start, double v) {
  constexpr double radius = 10;
  disc.step();
  const auto at = clapotis::row(disc.particles().position, 0);
  return std::max(std::abs(at.x - folded(start.x, v, radius, 800 - radius)),
                  std::abs(at.y - folded(start.y, -v / 3, radius, 600 - radius))) /
         std::abs(v);
}

Outcome cross_boxes(Effort /*effort*/) {
  using Values = std::vector<std::pair<std::string, std::string>>;
  const Values free{{"gravity", "0"}, {"drag", "0"}, {"restitution", "1"}, {"dt", "1"}};
  const auto with = [&](const char* name, Values values) {
    values.insert(values.end(), free.begin(), free.end());
    return simulation(scene(name, values));
  };
  const Vector start{123, 456};
  double worst = 0;
  bool reported = true;
  for (const double v : {7.8e5, -7.8e5, 1.23456e6, 1e9}) {
    for (const char* impacts : {"located", "clamp"}) {
      const auto ball = with("stage1/bounce", {{"x0", to_text(start.x)},
                                               {"y0", to_text(start.y)},
                                               {"vx0", to_text(v)},
                                               {"vy0", to_text(-v / 3)},
                                               {"impacts", impacts}});
      worst = std::max(worst, off_the_path(*ball, start, v));
      reported = reported && warned(*ball, "counted instead");
    }
    for (const char* name : {"stage2/cloud", "stage3/cloud"}) {
      const auto disc = with(name, {{"particles", "1"}});
      disc->edit([&](System& s) {
        s.position.row(0) << start.x, start.y;
        s.velocity.row(0) << v, -v / 3;
      });
      worst = std::max(worst, off_the_path(*disc, start, v));
      reported = reported && warned(*disc, "counted instead");
    }
  }
  return {fmt::format("inside; off the unfolded path by {} of its length; {}", shown(worst),
                      reported ? "reported" : "not reported"),
          worst < 1e-14 && reported};
}

Outcome crowd(Effort /*effort*/) {
  constexpr Index n = 700;
  const auto crowded = [](const char* stage) {
    auto discs = simulation(scene(stage, {{"particles", std::to_string(n)}, {"y0", "0"}, {"dt", "1e-6"}}));
    discs->edit([](System& s) { s.position = 300 + 14.0 / 800 * s.position; });  // a cell is 20 px wide
    return discs;
  };
  const auto spread =
      simulation(scene("stage3/cloud", {{"particles", std::to_string(n)}, {"y0", "0"}, {"dt", "1e-6"}}));
  const auto list = crowded("stage2/cloud"), grid = crowded("stage3/cloud");
  const Vectors exact = accelerations(*list), found = accelerations(*grid);
  const double off = std::sqrt((found - exact).square().rowwise().sum().maxCoeff() /
                               exact.square().rowwise().sum().maxCoeff());
  const auto pairs = grid->model().count_pairs(grid->particles()).neighbours;
  const auto water = simulation(scene("stage4/dam_break", {{"spacing", "0.1"}}));  // of support 0.3 m
  water->edit([](System& s) { s.position = 1 + 0.1 * s.position; });
  const auto size = water->particles().size();
  const bool all_met = water->model().count_pairs(water->particles()).neighbours == size * (size - 1);
  const double memory = grid->bytes_per_particle() / spread->bytes_per_particle();
  return {
      fmt::format("{} of {} ordered pairs met; {} in the liquid; the grid's forces differ from the list's by "
                  "{}; {} times the memory of the same discs spread out",
                  pairs, n * (n - 1), all_met ? "all" : "not all", shown(off), rounded(memory, 2)),
      pairs == n * (n - 1) && all_met && off < 1e-12 && memory < 1.5};
}

/// Four discs in a lattice of twelve immovable ones, so pressed that no contact opens.
Setup pressed(Parameters& p) {
  Setup setup{.particles = Particles(16, 1), .model = nullptr, .radius = 0};
  auto& mass = setup.particles.add_column("mass", "kg");
  for (Index i = 0; i < 16; ++i) {
    const auto line = static_cast<double>(i / 4), place = static_cast<double>(i % 4);
    setup.particles.position.row(i) << 0.8 * (place + line / 2), 0.8 * std::sqrt(0.75) * line;
    const bool inside = (i / 4 == 1 || i / 4 == 2) && (i % 4 == 1 || i % 4 == 2);
    mass(i) = inside ? 1 : 1e12;
    if (inside) setup.particles.velocity.row(i) << 0.07 * std::cos(i), 0.07 * std::sin(i);
  }
  setup.model = std::make_unique<FusedModel<AllPairs, StoredMass, ContactSpring>>(p);
  setup.radius = 0.5;
  return setup;
}

Outcome press_for_long(Effort effort) {
  const long steps = effort == Effort::quick ? 100000 : 1000000, tenth = steps / 10;
  const Scene scene{.name = "pressed",
                    .length_unit = "m",
                    .defaults = {{"radius", "0.5"}, {"stiffness", "1"}, {"dt", "0.1"}},
                    .build = pressed};
  Simulation discs(scene);
  const auto start = discs.energy();
  double worst = 0, first = 0, last = 0;
  for (long step = 0; step < steps; step += 10) {
    advance_steps(discs, 10);
    const double error = (discs.energy().mechanical() - start.mechanical()) / start.kinetic;
    worst = std::max(worst, std::abs(error));
    if (step < tenth) first += 10 * error / static_cast<double>(tenth);
    if (step >= steps - tenth) last += 10 * error / static_cast<double>(tenth);
  }
  const double drift = std::abs(last - first);
  return {fmt::format("{} steps; energy off by {} of its kinetic part at most; mean of the last tenth less "
                      "that of the first: {}",
                      steps, shown(worst), shown(drift)),
          worst < 0.01 && drift < 0.05 * worst};
}

Outcome collide(Effort /*effort*/) {
  double off = 0, lost = 0, steps_off = 0;
  bool named = true;
  for (const double ratio : {1e-6, 1e6}) {
    const auto discs = simulation(
        scene("stage2/pair", {{"mass_ratio", to_text(ratio)}, {"stiffness", "1e12"}, {"x0", "389.9999995"}}));
    const double lightest = std::min(1.0, ratio);
    steps_off = std::max(steps_off, std::abs(discs->dt() / (0.5 * 0.816 * std::sqrt(lightest / 1e12)) - 1));
    named = named && discs->binding_limit().name == "contact";
    const auto momentum = [&] {
      const auto& p = discs->particles();
      return p.mass(0) * p.velocity(0, 0) + p.mass(1) * p.velocity(1, 0);
    };
    const double before = momentum();
    advance_steps(*discs, 200);
    const auto& v = discs->particles().velocity;
    off = std::max(off, std::abs((v(1, 0) - v(0, 0)) / 400 - 1));
    lost = std::max(lost, std::abs(momentum() / before - 1));
  }
  return {
      fmt::format("the limit of the lightest mass to {}; they part as fast as they met to {}; momentum to {}",
                  shown(steps_off), shown(off), shown(lost)),
      named && steps_off < 1e-12 && off < 0.05 && lost < 1e-12};
}

}  // namespace

HardCase one_point() {
  return {"two particles at one point", "two discs (list and grid); two particles in a dam break",
          "finite; discs part and momentum stays 0 to 1e-12; same bits again; no force in a liquid; reported",
          meet_at_one_point};
}
HardCase exact_corner() {
  return {"exact corner", "4 corners; impacts located and clamped; 5 integrators",
          "v = -e v in both directions to 1e-12", fly_into_corners};
}
HardCase huge_speed() {
  return {"huge speed", "a step across 1000 to 1300000 boxes; impacts located and clamped; list and grid",
          "where the folded path ends to 1e-14 of its length; reported", cross_boxes};
}
HardCase crowded_cell() {
  return {"many particles in one cell",
          "700 discs in 14 x 14 px where a cell is 20 x 20 px; 200 particles of liquid in one support",
          "forces as all pairs give them to 1e-12; all pairs met; memory within 1.5 times", crowd};
}
HardCase million_steps() {
  return {"a million steps", "pressed discs without damping; Verlet; w dt about 0.25",
          "energy off by less than 0.01 of the kinetic; drift below 5 % of that", press_for_long};
}
HardCase extreme_masses() {
  return {"extreme masses and springs", "mass ratio 1e-6 and 1e6; stiffness 1e12 kg/s^2",
          "contact limit of the lightest mass named; relative speed kept to 5 %; momentum to 1e-12", collide};
}

}  // namespace clapotis::studies
