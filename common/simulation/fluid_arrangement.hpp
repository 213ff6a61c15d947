#pragma once

#include <cmath>

#include "common/particles/parallel.hpp"
#include "common/particles/period.hpp"
#include "common/simulation/fluid_columns.hpp"
#include "common/simulation/model.hpp"

namespace clapotis {

/// The particles of a fluid in the order of a grid of cells. Where the plane is periodic, those near an edge
/// appear a second time, as images beyond the opposite edge, which are seen but do not see.
class FluidArrangement {
 public:
  FluidArrangement(double support, const Period& period) : support_(support), period_(period) {}

  CellGrid grid{8};
  FluidColumns columns;

  /// Sorts, and brings positions and velocities along; then calls finish(slot, id) for what else is wanted.
  template <class Finish>
  void build(const Particles& particles, const Finish& finish) {
    sort(particles);
    const Vectors& places = periodic() ? places_ : particles.position;
    const double *x = places.col(0).data(), *y = places.col(1).data();
    const double *vx = particles.velocity.col(0).data(), *vy = particles.velocity.col(1).data();
    for_each(slots(), particles.threads, [&](Index slot) {
      const Index place = grid.id(slot), i = id(slot);
      columns.x(slot) = finite_or(x[place], far_away);
      columns.y(slot) = finite_or(y[place], far_away);
      columns.vx(slot) = finite_or(vx[i], 0);
      columns.vy(slot) = finite_or(vy[i], 0);
      finish(slot, i);
    });
  }

  /// A number, or what takes its place when it is none: 0 x NaN would reach the others of its pack.
  static double finite_or(double value, double instead) { return std::isfinite(value) ? value : instead; }

  [[nodiscard]] Index slots() const { return count_ + static_cast<Index>(images_.size()); }
  [[nodiscard]] bool is_image(Index slot) const { return grid.id(slot) >= count_; }
  /// The particle in a slot, or the one whose image it is.
  [[nodiscard]] Index id(Index slot) const {
    const Index k = grid.id(slot);
    return k < count_ ? k : images_[static_cast<std::size_t>(k - count_)];
  }
  /// Where a particle is; it is there, since `build` had it.
  [[nodiscard]] Index slot_of(Index particle) const;
  [[nodiscard]] const Period& period() const { return period_; }

  [[nodiscard]] Neighbourhood neighbourhood(const Vector& r, Index i) const;
  [[nodiscard]] PairCount count_pairs() const;
  [[nodiscard]] std::size_t bytes() const;

 private:
  static constexpr double far_away = 1e100;  ///< and yet (v d)^2 is a number [L]

  void sort(const Particles& particles);
  [[nodiscard]] bool periodic() const { return period_.length.x > 0 || period_.length.y > 0; }

  double support_;
  Period period_;
  Index count_ = 0;
  Vectors places_;                    ///< of particles and images, where the plane is periodic
  std::vector<std::int32_t> images_;  ///< whose image each is
};

/// Adds to what is seen from r the particles in `columns` that are within the support.
void add_seen(KernelAround& seen, const Vector& r, const CellGrid& grid, const FluidColumns& columns,
              bool wall);

}  // namespace clapotis
