#pragma once

#include <utility>

#include "common/kernels/kernel.hpp"
#include "common/laws/dummy_walls.hpp"
#include "common/laws/implicit.hpp"
#include "common/neighbours/packs_near.hpp"
#include "common/simulation/fluid_arrangement.hpp"
#include "common/simulation/scene.hpp"

namespace clapotis {

/// What solving for the velocities at the end of a step came to.
struct Solved {
  long iterations = 0;
  double residual = 0;  ///< |v* + dt/m F(v) - v| over |v|
  double taken = 0;     ///< kinetic energy, sum_i (v*^2 - v^2)/2, per unit of mass [L^2/s^2]
};

/// What `solved`, which a model keeps, says of the last step: columns of series.csv.
inline std::vector<Measure> measures_of(const Solved& solved) {
  return {
      {"viscous_iterations", "1", [&](const System&) { return static_cast<double>(solved.iterations); }},
      {"viscous_residual", "1", [&](const System&) { return solved.residual; }},
  };
}

/// dt/m F(v), the changes of velocity by the friction between the particles of a fluid and by its walls, by
/// a sweep over the neighbours for any v: no matrix is stored.
///
/// F is symmetric, for the coefficients of a pair are: each pair takes V_i V_j times a positive
/// (semi)definite form of v_ij out of the motion. So is the part of the walls, if <v> in the mirrored
/// velocity 2 v_w - <v> of a wall's particle is the mean that the friction itself makes: the velocity at
/// which the fluid around would not rub that particle, sum_f K_f (v_f - <v>) = 0, K_f the 2x2 coefficients of
/// the pair. The walls then take sum_f v_f.K_f v_f + <v>.(sum_f K_f) <v> >= 0. With the means of
/// `DummyWalls`, weighted by W, the matrix would have no symmetry, and conjugate gradients no ground to stand
/// on.
template <class Kernel, class Friction>
class FrictionSweep {
 public:
  FrictionSweep(const Implicit<Friction>& law, const Kernel& kernel, FluidArrangement& fluid,
                DummyWalls& walls, double dt_over_mass, int threads)
      : law_(law.friction),
        kernel_(kernel),
        fluid_(fluid),
        walls_(walls),
        dt_over_mass_(dt_over_mass),
        threads_(threads),
        rubs_walls_(!law.slips && walls.size() > 0) {}

  /// change = dt/m F(v), one row per particle. F is affine where walls slide; without their motion it is
  /// linear.
  void apply(const Vectors& v, bool walls_move, Vectors& change) const {
    for_each(fluid_.slots(), threads_, [&](Index slot) {
      const Index i = fluid_.id(slot);
      fluid_.columns.vx(slot) = v(i, 0);
      fluid_.columns.vy(slot) = v(i, 1);
    });
    if (rubs_walls_) {
      for_each(walls_.size(), threads_, [&](Index slot) { mirror(slot, walls_move); });
      walls_.copy_to_images();
    }
    for_each(fluid_.slots(), threads_, [&](Index slot) {
      if (fluid_.is_image(slot)) return;
      const Vector force = force_on(slot);
      change(fluid_.id(slot), 0) = dt_over_mass_ * force.x;
      change(fluid_.id(slot), 1) = dt_over_mass_ * force.y;
    });
  }

  /// dt/m F(v) of the particle in `slot` alone, with the velocities that the fluid's columns hold.
  [[nodiscard]] Vector change_of(Index slot) const {
    if (rubs_walls_) {
      for_each(walls_.size(), threads_, [&](Index wall) { mirror(wall, true); });
      walls_.copy_to_images();
    }
    return dt_over_mass_ * force_on(slot);
  }

 private:
  /// V_i sum_j V_j [stress d + friction v_ij] W'/r, walls included.
  [[gnu::flatten]] Vector force_on(Index slot) const {
    const auto& c = fluid_.columns;
    const auto i = c.at(slot);
    const Vec<Pack> velocity{Pack(i.velocity.x), Pack(i.velocity.y)};
    Vec<Pack> sum{Pack(0.0), Pack(0.0)};
    const auto meet = [&](const FluidColumns& others) {
      return [&](Run at, const Vec<Pack>& d, const Pack& r2) __attribute__((always_inline)) {
        const Pack inverse = inverse_sqrt(r2);
        const auto j = others.at(at);
        const Vec<Pack> v = velocity - j.velocity;
        const Meeting ij{d, inverse, dot(v, d)};
        const Pack weight = j.volume * kernel_.slope_over_r(r2 * inverse, inverse);
        if constexpr (ActsByStress<Friction>) sum += (weight * law_.stress(i, j, ij)) * d;
        if constexpr (ActsByFriction<Friction>) sum += (weight * law_.friction(i, j, ij)) * v;
      };
    };
    around(fluid_.grid, c, c.position(slot), meet(c));
    if (rubs_walls_ && walls_.near(c.position(slot)))
      around(walls_.grid, walls_.columns, c.position(slot), meet(walls_.columns));
    return i.volume * Vector{clapotis::sum(sum.x), clapotis::sum(sum.y)};
  }

  /// 2 v_w - <v>, (sum_f K_f) <v> = sum_f K_f v_f. Where the fluid around does not fix <v> in all directions,
  /// it is 0 along the others; a millionth of the trace of sum K decides.
  [[gnu::flatten]] void mirror(Index slot, bool walls_move) const {
    auto& c = walls_.columns;
    const auto w = c.at(slot);
    Pack xx(0.0), xy(0.0), yy(0.0);
    Vec<Pack> rubbed{Pack(0.0), Pack(0.0)};
    around(
        fluid_.grid, fluid_.columns,
        c.position(slot), [&](Run at, const Vec<Pack>& d, const Pack& r2) __attribute__((always_inline)) {
          const Pack inverse = inverse_sqrt(r2);
          const auto j = fluid_.columns.at(at);
          const Meeting one{d, inverse, Pack(1.0)};
          const Pack weight = j.volume * kernel_.slope_over_r(r2 * inverse, inverse);
          if constexpr (ActsByStress<Friction>) {
            const Pack k = weight * law_.stress(w, j, one);
            xx += k * d.x * d.x, xy += k * d.x * d.y, yy += k * d.y * d.y;
            rubbed += (k * dot(j.velocity, d)) * d;
          }
          if constexpr (ActsByFriction<Friction>) {
            const Pack k = weight * law_.friction(w, j, one);
            xx += k, yy += k;
            rubbed += k * j.velocity;
          }
        });
    const double little = 1e-6 * (sum(xx) + sum(yy)), a = sum(xx) + little, b = sum(xy), d = sum(yy) + little;
    const double determinant = a * d - b * b;
    Vector mean{0, 0};
    if (determinant > 0) {
      const Vector f{sum(rubbed.x), sum(rubbed.y)};
      mean = (1 / determinant) * Vector{d * f.x - b * f.y, a * f.y - b * f.x};
    }
    const Vector own = walls_move ? walls_.own_velocity(slot) : Vector{0, 0};
    c.vx(slot) = 2 * own.x - mean.x;
    c.vy(slot) = 2 * own.y - mean.y;
  }

  template <class Meet>
  [[gnu::always_inline]] void around(const CellGrid& grid, const FluidColumns& c, const Vector& r,
                                     const Meet& meet) const {
    packs_near(grid, c.x.data(), c.y.data(), r, kernel_.support(), meet);
  }

  const Friction& law_;
  const Kernel& kernel_;
  FluidArrangement& fluid_;
  DummyWalls& walls_;
  double dt_over_mass_;
  int threads_;
  bool rubs_walls_;
};

/// Turns v* into the v of v - dt/m F(v) = v*, by conjugate gradients (Hestenes & Stiefel 1952) from v* on.
/// The matrix has no eigenvalue below 1, so that v is at most as wrong as its residual is large. It leaves
/// alone whatever F does, moving or turning as a whole, and every residual is a sum of forces: without walls
/// each iterate keeps momentum, with any tolerance. A preconditioner would lose that. Sums are taken in fixed
/// order: the same bits with any number of threads. A v* that is not finite stays as it is.
template <class Sweep>
Solved solve_implicitly(const Sweep& friction, Vectors& v, double tolerance, int threads) {
  const Index n = v.rows();
  threads = threads_for_little(n, threads);
  const auto square_of = [&](const Vectors& a) {
    return sum_over(n, threads, [&](Index i, std::size_t) { return dot(row(a, i), row(a, i)); });
  };
  Vectors residual(n, 2), direction(n, 2), changed(n, 2);
  friction.apply(v, true, residual);
  direction = residual;
  double rr = square_of(residual), vv = square_of(v);
  const double at_first = vv;
  Solved solved;
  while (rr > tolerance * tolerance * vv && solved.iterations < 2 * n) {
    friction.apply(direction, false, changed);
    const double along = rr / sum_over(n, threads, [&](Index i, std::size_t) {
                           const Vector d = row(direction, i);
                           return dot(d, d - row(changed, i));
                         });
    for_rows(n, threads, [&](Index first, Index count) {
      const auto rows = [&](auto& all) { return all.middleRows(first, count); };
      rows(v) += along * rows(direction);
      rows(residual) -= along * (rows(direction) - rows(changed));
    });
    const double before = std::exchange(rr, square_of(residual));
    vv = square_of(v);
    for_rows(n, threads, [&](Index first, Index count) {
      direction.middleRows(first, count) =
          residual.middleRows(first, count) + rr / before * direction.middleRows(first, count);
    });
    ++solved.iterations;
  }
  solved.residual = rr > 0 ? std::sqrt(rr / vv) : 0;
  solved.taken = (at_first - vv) / 2;
  return solved;
}

}  // namespace clapotis
