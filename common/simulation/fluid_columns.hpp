#pragma once

#include <cmath>

#include "common/laws/law.hpp"
#include "common/neighbours/cell_grid.hpp"
#include "common/simulation/parallel.hpp"

namespace clapotis {

/// What the laws of a fluid read, in the order of a grid of cells, so that those near a particle are
/// contiguous and a pack of them is one load. Behind the last follows one pack of ones, so that a load never
/// leaves the column.
struct FluidColumns {
  Column x, y, vx, vy, density, volume, pressure;

  void resize(Index n) {
    for (Column* column : all())
      if (column->size() != n + pack_width) *column = Column::Ones(n + pack_width);
  }
  [[nodiscard]] Vector position(Index slot) const { return {x(slot), y(slot)}; }
  [[nodiscard]] FluidParticle<double> at(Index slot) const { return particle<double>(slot); }
  [[nodiscard]] FluidParticle<Pack> at(Run slots) const { return particle<Pack>(slots); }

  /// sorted = column in the order of the grid. `instead` takes the place of what is not a number: 0 x NaN
  /// would reach the others of its pack.
  template <class Order>
  static void gather(Column& sorted, Index slots, const double* column, double instead, int threads,
                     const Order& id) {
    for_each(slots, threads, [&](Index slot) {
      const double value = column[id(slot)];
      sorted(slot) = std::isfinite(value) ? value : instead;
    });
  }
  [[nodiscard]] std::size_t bytes() const { return 7 * static_cast<std::size_t>(x.size()) * sizeof(double); }

 private:
  std::array<Column*, 7> all() { return {&x, &y, &vx, &vy, &density, &volume, &pressure}; }

  template <class T>
  [[nodiscard]] FluidParticle<T> particle(auto at) const {
    return {.velocity = {load(vx.data(), at), load(vy.data(), at)},
            .density = load(density.data(), at),
            .volume = load(volume.data(), at),
            .pressure = load(pressure.data(), at)};
  }
};

}  // namespace clapotis
