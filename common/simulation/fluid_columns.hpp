#pragma once

#include <array>

#include "common/laws/law.hpp"
#include "common/neighbours/cell_grid.hpp"

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
