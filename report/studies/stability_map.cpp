#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "common/references/spring_pair.hpp"
#include "common/references/stability_limits.hpp"
#include "common/simulation/errors.hpp"
#include "report/studies/conclusion.hpp"
#include "report/studies/measured.hpp"
#include "report/studies/oscillator.hpp"
#include "report/studies/pressed_row.hpp"
#include "report/studies/studies.hpp"

namespace clapotis::studies {
namespace {

constexpr double not_a_number = std::numeric_limits<double>::quiet_NaN();
constexpr std::array schemes{"explicit_euler", "symplectic_euler", "velocity_verlet", "rk2", "rk4"};
constexpr double shortest = 0.01, longest = 6;  // dt c/h or w dt that is tried
constexpr double growth = 1e4;                  // of the kinetic energy, beyond which a run is unstable

/// Steps in which it must not happen. Explicit Euler grows slowly.
int steps_of(std::string_view scheme) { return scheme == "explicit_euler" ? 3000 : 1200; }

struct Lattice {
  const char *name, *kernel;
  double h_over_dx;
};
constexpr std::array lattices{Lattice{"cubic spline", "cubic_spline", 1.3},
                              Lattice{"Wendland C2", "wendland_c2", 1.5}};
constexpr auto spring = "spring", contact = "contact";

/// Twice the kinetic energy, for masses of 1.
double squared_speeds(const Simulation& simulation) { return simulation.particles().velocity.square().sum(); }

/// Whether the squared speeds pass `bound` in so many steps, or the run is lost.
bool grows(Simulation& simulation, int steps, double bound) {
  try {
    for (int step = 0; step < steps; ++step) {
      simulation.step();
      if (!(squared_speeds(simulation) < bound)) return true;
    }
  } catch (const Diverged&) {
    return true;
  }
  heed_interrupt();
  return false;
}

/// The longest step that is stable, to `exact` of it; 0 where the shortest is not.
double limit(const std::function<bool(double)>& unstable, double exact) {
  double stable = shortest, grown = longest;
  if (unstable(stable)) return 0;
  while (grown / stable > 1 + exact) {
    const double middle = std::sqrt(stable * grown);
    (unstable(middle) ? grown : stable) = middle;
  }
  return stable;
}

std::string lattice_text(const Lattice& lattice, std::string_view scheme, double alpha, double dt_c_over_h) {
  return scene("stage4/acoustic", {{"kernel", lattice.kernel},
                                   {"h_over_dx", to_text(lattice.h_over_dx)},
                                   {"alpha", to_text(alpha)},
                                   {"integrator", std::string(scheme)},
                                   {"dt", to_text(dt_c_over_h * lattice.h_over_dx)}});  // dx = c = 1
}

/// The greatest squared speeds of the disturbed lattice while nothing grows.
double calm(const Lattice& lattice, double alpha) {
  const auto still = simulation(lattice_text(lattice, "velocity_verlet", alpha, 0.1));
  double most = 0;
  advance_steps(*still, 400, [&](Simulation& now) { most = std::max(most, squared_speeds(now)); });
  return most;
}

/// Of stability_limits.hpp, where it has one. What it says of symplectic Euler holds for Verlet, which
/// predicts the velocity that damps, only as long as damping does not decide.
double published(const StabilityLimits& limits, std::string_view scheme) {
  if (scheme == "explicit_euler") return limits.explicit_euler;
  if (scheme == "rk2") return limits.rk2;
  return scheme == "rk4" ? limits.rk4 : limits.symplectic_euler;
}
double published(const Lattice& lattice, std::string_view scheme, double alpha) {
  for (const auto& known : sph_stability_limits)
    if (known.kernel == lattice.kernel && known.alpha == alpha &&
        !(alpha > 0.1 && scheme == "velocity_verlet"))
      return published(known.dt_c_over_h, scheme);
  return not_a_number;
}

/// Factor per step with which theory has a run grow as much as makes it unstable.
double growth_per_step(std::string_view scheme) { return std::pow(growth, 0.5 / steps_of(scheme)); }

std::vector<Row> lattice_limit(const Lattice& lattice, const char* scheme, double alpha, double exact) {
  const double bound = growth * calm(lattice, alpha);
  const double found = limit(
      [&](double dt) {
        const auto run = simulation(lattice_text(lattice, scheme, alpha, dt));
        return grows(*run, steps_of(scheme), bound);
      },
      exact);
  const double h = lattice.h_over_dx;
  const double theory = stability_limit(scheme, lattice_waves(lattice.kernel, h, alpha, 12),
                                        growth_per_step(scheme), shortest * h, longest * h);
  return one_row(found, theory / h, published(lattice, scheme, alpha), not_a_number, not_a_number,
                 not_a_number);
}

/// One disc, pressed between two that do not move: x'' = -w^2 x - 2 zeta w x'.
std::vector<Row> spring_limit(const char* scheme, double zeta, double exact) {
  constexpr double stiffness = 1.5e5, mass = 1;  // of scene pair
  const double w = highest_frequency(1, stiffness, mass);
  const double found = limit(
      [&](double w_dt) {
        const auto run = pressed_row(
            1, {{"drag", to_text(2 * zeta * w * mass)}, {"integrator", scheme}, {"dt", to_text(w_dt / w)}});
        return grows(*run, steps_of(scheme), growth * squared_speeds(*run));
      },
      exact);
  const auto one = [](double value) { return Eigen::MatrixXd::Constant(1, 1, value); };
  const double theory =
      stability_limit(scheme, {{one(1), one(2 * zeta)}}, growth_per_step(scheme), shortest, longest);
  return one_row(found, theory, zeta == 0 ? published(oscillator_limits, scheme) : not_a_number, not_a_number,
                 not_a_number, not_a_number);
}

/// Speed after over speed before a single contact, over many moments of the step at which the discs may meet:
/// its mean, its largest, and the mean of its square, which is the energy.
std::vector<Row> restitution(const char* scheme, double w_dt, int moments) {
  constexpr double stiffness = 1.5e5, speed = 200, radius = 10, middle = 400;  // of scene pair
  const double dt = w_dt / std::sqrt(2 * stiffness);
  double sum = 0, squares = 0, most = 0;
  for (int moment = 0; moment < moments; ++moment) {
    const double gap = (moment + 0.5) / moments * 2 * speed * dt;
    const auto run = simulation(
        scene("stage2/pair",
              {{"x0", to_text(middle - radius - gap / 2)}, {"integrator", scheme}, {"dt", to_text(dt)}}));
    const auto& p = run->particles();
    double closing = 0;
    do {
      run->step();
      closing = p.velocity(0, 0) - p.velocity(1, 0);
    } while (p.position(1, 0) - p.position(0, 0) < 2 * radius || closing > 0);
    const double found = -closing / (2 * speed);
    sum += found;
    squares += found * found;
    most = std::max(most, found);
  }
  const double theory = std::string_view(scheme) == "explicit_euler" ? explicit_euler_restitution(w_dt) : 1;
  return one_row(not_a_number, theory, not_a_number, sum / moments, most, squares / moments);
}

std::vector<Point> points(Effort effort) {
  const bool quick = effort == Effort::quick;
  const std::vector<double> damping = quick ? std::vector{0.0, 0.1, 0.4, 1.0}
                                            : std::vector{0.0, 0.05, 0.1, 0.2, 0.3, 0.4, 0.5, 0.6, 0.8, 1.0};
  const double exact = quick ? 0.03 : 0.01;
  std::vector<Point> all;
  for (const char* scheme : schemes)
    for (double w_dt = 0.025; w_dt < 3.3; w_dt *= std::pow(2, quick ? 1 : 0.25))
      all.push_back({.key = row(contact, scheme, not_a_number, w_dt),
                     .measure = [=] { return restitution(scheme, w_dt, quick ? 64 : 256); },
                     .weight = 0.1});
  for (const char* scheme : schemes)
    for (const double zeta : damping)
      all.push_back({.key = row(spring, scheme, zeta, not_a_number),
                     .measure = [=] { return spring_limit(scheme, zeta, exact); },
                     .weight = 0.1});
  for (const auto& lattice : lattices)
    for (const char* scheme : schemes)
      for (const double alpha : damping)
        all.push_back({.key = row(lattice.name, scheme, alpha, not_a_number),
                       .measure = [=] { return lattice_limit(lattice, scheme, alpha, exact); }});
  return all;
}

std::string limit_at(const Table& table, std::string_view map, std::string_view scheme, double damping) {
  const auto rows = table.where({{"map", map}, {"scheme", scheme}, {"damping", cell(damping)}});
  return rows.empty() ? "-" : rounded(table.number(rows[0], "limit"));
}

/// How far the limits that were found are from those of theory, at most, where theory has one.
double furthest_from_theory(const Table& table, std::string_view map, std::string_view scheme) {
  double most = 0;
  for (const auto& each : table.where({{"map", map}, {"scheme", scheme}})) {
    const double found = table.number(each, "limit"), theory = table.number(each, "theory");
    if (theory > 0) most = greater(most, std::abs(found / theory - 1));
  }
  return most;
}

Conclusion conclude(const Table& table) {
  Conclusion conclusion;
  TextTable limits{.name = "limits", .header = {"scheme"}, .rows = {}};
  const std::array maps{lattices[0].name, lattices[1].name, spring};
  for (const char* map : maps)
    for (const char* damping : {"0", "0.1", "1"}) limits.header.push_back(std::string(map) + ' ' + damping);
  for (const char* scheme : schemes) {
    Row line{spoken(scheme)};
    for (const char* map : maps)
      for (const double damping : {0.0, 0.1, 1.0}) line.push_back(limit_at(table, map, scheme, damping));
    limits.rows.push_back(line);
    for (const char* map : maps)
      conclusion.findings.push_back({std::string(scheme) + '_' +
                                         (map == spring    ? spring
                                          : map == maps[0] ? "cubic"
                                                           : "wendland"),
                                     rounded(100 * furthest_from_theory(table, map, scheme), 2), "%",
                                     std::string(scheme) + ", " + map + ": furthest from theory"});
    double coarse = not_a_number, fine = not_a_number, gain = not_a_number;
    for (const auto& each : table.where({{"map", contact}, {"scheme", scheme}})) {
      const double w_dt = table.number(each, "w_dt"), found = table.number(each, "restitution");
      if (w_dt > 0.79 && w_dt < 0.81) coarse = found - 1;
      if (w_dt > 0.09 && w_dt < 0.11) fine = found - 1;
      if (w_dt > 0.39 && w_dt < 0.41) gain = table.number(each, "energy") - 1;
    }
    conclusion.findings.push_back({std::string(scheme) + "_contact_fine", rounded(fine, 2), "",
                                   std::string(scheme) + ": restitution less 1 at w dt = 0.1"});
    conclusion.findings.push_back({std::string(scheme) + "_contact_coarse", rounded(coarse, 2), "",
                                   std::string(scheme) + ": restitution less 1 at w dt = 0.8"});
    conclusion.findings.push_back({std::string(scheme) + "_contact_energy", rounded(gain, 2), "",
                                   std::string(scheme) + ": energy gained per contact at w dt = 0.4"});
  }
  conclusion.tables.push_back(limits);
  return conclusion;
}

}  // namespace

/// `damping` is alpha of the lattices and the damping ratio of the spring; `limit` is dt c/h and w dt.
Study stability_map() {
  return {.name = "stability_map",
          .question = "How long may a step be, for each integrator, in a lattice of SPH and on a spring?",
          .keys = {{"map", ""}, {"scheme", ""}, {"damping", "1"}, {"w_dt", "1"}},
          .values = {{"limit", "1"},
                     {"theory", "1"},
                     {"reference", "1"},
                     {"restitution", "1"},
                     {"largest_restitution", "1"},
                     {"energy", "1"}},
          .points = points,
          .conclude = conclude};
}

}  // namespace clapotis::studies
