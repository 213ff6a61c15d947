#pragma once

#include "common/kernels/kernel.hpp"
#include "common/laws/dummy_walls.hpp"
#include "common/neighbours/packs_near.hpp"
#include "common/simulation/fluid_arrangement.hpp"

namespace clapotis {

/// The particles of a fluid and those of its walls, each in the order of a grid of cells, and who is near
/// whom under the kernel.
template <class Kernel>
struct FluidNeighbours {
  FluidNeighbours(double h, const Period& period, DummyWalls around)
      : kernel(h), fluid(kernel.support(), period), walls(std::move(around)) {}

  Kernel kernel;
  FluidArrangement fluid;
  DummyWalls walls;

  /// Calls meet(j, d, r, 1/r) for the packs of fluid particles around r.
  template <class Meet>
  [[gnu::always_inline]] void around(const Vector& r, const Meet& meet) const {
    const auto& c = fluid.columns;
    packs_near(fluid.grid, c.x.data(), c.y.data(), r, kernel.support(), with_distance(meet));
  }
  /// The same for the particles of walls.
  template <class Meet>
  [[gnu::always_inline]] void around_walls(const Vector& r, const Meet& meet) const {
    if (walls.size() == 0 || !walls.near(r)) return;
    const auto& c = walls.columns;
    packs_near(walls.grid, c.x.data(), c.y.data(), r, kernel.support(), with_distance(meet));
  }
  template <class Meet>
  static auto with_distance(const Meet& meet) {
    return [&meet](Run j, const Vec<Pack>& d, const Pack& r2) __attribute__((always_inline)) {
      const Pack inverse = inverse_sqrt(r2);
      meet(j, d, r2 * inverse, inverse);
    };
  }

  /// sum_j W, walls included.
  [[gnu::flatten]] double sum_of_kernels(const Vector& r) const {
    Pack total(0.0);
    const auto meet = [&](Run, const Vec<Pack>&, const Pack& distance, const Pack&) {
      total += kernel.value(distance);
    };
    around(r, meet);
    around_walls(r, meet);
    return sum(total);
  }

  /// The kernel and all that it weighs, from a particle of the fluid.
  [[nodiscard]] KernelAround seen_from(Index particle) const {
    KernelAround seen{.h = kernel.support() / 2,
                      .support = kernel.support(),
                      .value = [k = kernel](double r) { return k.value(r); },
                      .slope = [k = kernel](double r) { return r > 0 ? r * k.slope_over_r(r, 1 / r) : 0; }};
    const Vector r = fluid.columns.position(fluid.slot_of(particle));
    add_seen(seen, r, fluid.grid, fluid.columns, false);
    if (walls.size() > 0) add_seen(seen, r, walls.grid, walls.columns, true);
    return seen;
  }

  /// curl v = sum_j V_j (v_ij x d) W'/r, z upwards; v_ij = v_i - v_j.
  [[gnu::flatten]] double curl_at(Index slot) const {
    const auto& c = fluid.columns;
    const auto i = c.at(slot);
    const Vec<Pack> velocity{Pack(i.velocity.x), Pack(i.velocity.y)};
    Pack curl(0.0);
    around(c.position(slot), [&](Run at, const Vec<Pack>& d, const Pack& r, const Pack& inverse) {
      const auto j = c.at(at);
      const Vec<Pack> v = velocity - j.velocity;
      curl += j.volume * kernel.slope_over_r(r, inverse) * (v.x * d.y - v.y * d.x);
    });
    return sum(curl);
  }
};

}  // namespace clapotis
