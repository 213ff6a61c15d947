#pragma once

#include <cmath>
#include <functional>
#include <numbers>
#include <string>

#include "common/particles/particles.hpp"
#include "common/simulation/parameters.hpp"

/// The formulas of the textbook, all pairs, one number at a time: what the sweeps of a fluid are measured
/// against. They are typed here a second time, and call neither kernels nor laws.
namespace clapotis::tests {

/// Sums of one number per particle, and of the magnitudes of their terms: what round-off is measured by.
struct Sums {
  Column value, scale;
  explicit Sums(Index n) : value(Column::Zero(n)), scale(Column::Zero(n)) {}
  void add(Index i, double term) {
    value(i) += term;
    scale(i) += std::abs(term);
  }
};

/// The largest difference, each by its own scale.
inline double difference(const Column& computed, const Sums& exact) {
  return ((computed - exact.value).abs() / (exact.scale + 1e-300)).maxCoeff();
}

/// A liquid as its parameters describe it, in a plane that repeats itself with `period`; 0: it does not.
struct Liquid {
  bool wendland, sum, tension, sticks;
  double h, dx, m, rho0, c, gamma, alpha, delta, nu, epsilon, g;
  Vector period{0, 0};

  static Liquid from(const Parameters& p) {
    const auto number = [&](const char* name) { return p.find(name) != nullptr ? p.value(name) : 0; };
    const auto word = [&](const char* name) { return p.find(name) != nullptr ? p.find(name)->text() : ""; };
    return {.wendland = word("kernel") == "wendland_c2",
            .sum = word("density") == "summation",
            .tension = word("tension") == "yes",
            .sticks = word("slip") == "no",
            .h = number("smoothing_length"),
            .dx = number("spacing"),
            .m = number("particle_mass"),
            .rho0 = number("reference_density"),
            .c = number("sound_speed"),
            .gamma = number("gamma"),
            .alpha = number("alpha"),
            .delta = number("delta"),
            .nu = number("nu"),
            .epsilon = number("epsilon"),
            .g = number("gravity")};
  }

  /// Monaghan & Lattanzio 1985; Wendland 1995.
  [[nodiscard]] double w(double r) const {
    const double q = r / h, pi_h2 = std::numbers::pi * h * h;
    if (q >= 2) return 0;
    if (wendland) return 7 / (4 * pi_h2) * std::pow(1 - q / 2, 4) * (1 + 2 * q);
    return 10 / (7 * pi_h2) * (q < 1 ? 1 - 1.5 * q * q + 0.75 * q * q * q : std::pow(2 - q, 3) / 4);
  }
  /// W'(r)
  [[nodiscard]] double slope(double r) const {
    const double q = r / h, pi_h3 = std::numbers::pi * h * h * h;
    if (q >= 2) return 0;
    if (wendland) return -7 / (4 * pi_h3) * 5 * q * std::pow(1 - q / 2, 3);
    return 10 / (7 * pi_h3) * (q < 1 ? -3 * q + 2.25 * q * q : -0.75 * (2 - q) * (2 - q));
  }
  [[nodiscard]] double stiffness() const { return rho0 * c * c / gamma; }
  /// Cole 1948
  [[nodiscard]] double pressure(double density) const {
    const double p = stiffness() * (std::pow(density / rho0, gamma) - 1);
    return p < 0 && !tension ? 0 : p;
  }
  [[nodiscard]] double density(double pressure) const {
    return rho0 * std::pow(pressure / stiffness() + 1, 1 / gamma);
  }
};

/// What a liquid of these particles does at this instant.
struct BruteForce {
  Sums density, rate, pressure, wall_pressure, ax, ay;
  Column wall_density;
  long long neighbours = 0;  ///< ordered pairs of the fluid
};

/// One pair: separation d = r_i - r_j, distance r.
using Visit = std::function<void(Index j, double dx, double dy, double r)>;

inline void each_within(const Liquid& liquid, const Vector& at, const Vectors& others, const Visit& visit) {
  const int across = liquid.period.x > 0 ? 1 : 0, up = liquid.period.y > 0 ? 1 : 0;
  for (Index j = 0; j < others.rows(); ++j)
    for (int a = -across; a <= across; ++a)
      for (int b = -up; b <= up; ++b) {
        const double dx = at.x - others(j, 0) - a * liquid.period.x;
        const double dy = at.y - others(j, 1) - b * liquid.period.y;
        const double r = std::sqrt(dx * dx + dy * dy);
        if (r < 2 * liquid.h) visit(j, dx, dy, r);
      }
}

/// Continuity and sum of densities, Monaghan 2005; diffusion, Molteni & Colagrossi 2009 and Fourtakas et al.
/// 2019; walls, Adami, Hu & Adams 2012; viscosities, Monaghan & Gingold 1983 and Morris, Fox & Zhu 1997;
/// tensile correction, Monaghan 2000.
inline BruteForce brute_force(const Liquid& l, const Vectors& r, const Vectors& v, const Column& density,
                              const Vectors& walls) {
  const Index n = r.rows(), n_walls = walls.rows();
  BruteForce f{Sums(n), Sums(n), Sums(n), Sums(n_walls), Sums(n), Sums(n), Column(n_walls)};

  f.density.value = f.density.scale = density;
  if (l.sum) {
    f.density = Sums(n);
    for (Index i = 0; i < n; ++i) {
      const auto add = [&](Index, double, double, double distance) { f.density.add(i, l.m * l.w(distance)); };
      each_within(l, row(r, i), r, add);
      each_within(l, row(r, i), walls, add);
    }
  }
  const Column& rho = f.density.value;
  for (Index i = 0; i < n; ++i) {
    f.pressure.value(i) = l.pressure(rho(i));
    f.pressure.scale(i) = l.stiffness() * (std::pow(rho(i) / l.rho0, l.gamma) + 1);
  }
  const Column& p = f.pressure.value;

  Vectors wall_velocity = Vectors::Zero(n_walls, 2);
  for (Index k = 0; k < n_walls; ++k) {
    double weights = 0;
    each_within(l, row(walls, k), r, [&](Index j, double, double dy, double distance) {
      const double w = l.w(distance);
      weights += w;
      f.wall_pressure.add(k, w * p(j));
      f.wall_pressure.add(k, w * rho(j) * -l.g * dy);
      wall_velocity.row(k) -= w * v.row(j);
    });
    if (weights > 0) {
      f.wall_pressure.value(k) /= weights;
      f.wall_pressure.scale(k) /= weights;
      wall_velocity.row(k) /= weights;
    }
    if (!l.tension) f.wall_pressure.value(k) = std::max(f.wall_pressure.value(k), 0.0);
    f.wall_density(k) = l.rho0;
  }

  const auto pull = [&](double pi, double rho_i, double pj, double rho_j) {  // (L/s^2) per m W'
    return l.sum ? pi / (rho_i * rho_i) + pj / (rho_j * rho_j) : (pi + pj) / (rho_i * rho_j);
  };
  for (Index i = 0; i < n; ++i) {
    const auto accelerate = [&](double x, double y) {
      f.ax.value(i) += x;
      f.ay.value(i) += y;
      const double size = std::sqrt(x * x + y * y);
      f.ax.scale(i) += size;
      f.ay.scale(i) += size;
    };
    accelerate(0, -l.g);
    each_within(l, row(r, i), r, [&](Index j, double dx, double dy, double distance) {
      if (distance == 0) return;
      if (i != j) ++f.neighbours;
      const double slope = l.slope(distance), ux = dx / distance, uy = dy / distance;
      const double vx = v(i, 0) - v(j, 0), vy = v(i, 1) - v(j, 1), closing = vx * ux + vy * uy;
      f.rate.add(i, rho(i) * l.m / rho(j) * closing * slope);
      const double diffusion = 2 * l.delta * l.h * l.c * l.m / rho(j) * slope / distance;
      f.rate.add(i, diffusion * rho(i));
      f.rate.add(i, -diffusion * rho(j));
      f.rate.add(i, diffusion * l.rho0 * l.g * dy / (l.c * l.c));

      const double pushed = -l.m * pull(p(i), rho(i), p(j), rho(j)) * slope;
      accelerate(pushed * ux, pushed * uy);
      const double strained = std::max(-p(i), 0.0) + std::max(-p(j), 0.0);
      const double parted =
          -l.m * l.epsilon * strained / (rho(i) * rho(j)) * std::pow(l.w(distance) / l.w(l.dx), 4) * slope;
      accelerate(parted * ux, parted * uy);
      const double mu = closing < 0 ? l.h * closing / distance : 0;
      const double braked = l.m * l.alpha * l.rho0 * l.c * mu / (rho(i) * rho(j)) * slope;
      accelerate(braked * ux, braked * uy);
      const double rubbed = l.m * 2 * l.rho0 * l.nu / (rho(i) * rho(j)) * slope / distance;
      accelerate(rubbed * vx, rubbed * vy);
    });
    each_within(l, row(r, i), walls, [&](Index k, double dx, double dy, double distance) {
      const double slope = l.slope(distance), ux = dx / distance, uy = dy / distance;
      const double rho_w = f.wall_density(k), closing = v(i, 0) * ux + v(i, 1) * uy;
      f.rate.add(i, rho(i) * l.m / rho_w * closing * slope);
      const double pushed = -l.m * pull(p(i), rho(i), f.wall_pressure.value(k), rho_w) * slope;
      accelerate(pushed * ux, pushed * uy);
      const double rubbed = l.sticks ? l.m * 2 * l.rho0 * l.nu / (rho(i) * rho_w) * slope / distance : 0;
      accelerate(rubbed * (v(i, 0) - wall_velocity(k, 0)), rubbed * (v(i, 1) - wall_velocity(k, 1)));
    });
  }
  return f;
}

}  // namespace clapotis::tests
