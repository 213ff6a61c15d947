#include "common/simulation/fluid_arrangement.hpp"

#include <cmath>

#include "common/neighbours/packs_near.hpp"

namespace clapotis {

void FluidArrangement::sort(const Particles& particles) {
  count_ = particles.size();
  images_.clear();
  if (periodic()) {  // an integrator may have carried some beyond the edge, where they would see no images
    Vectors wrapped = particles.position;
    period_.wrap(wrapped);
    const auto images = period_.images(wrapped, support_);
    places_.resize(count_ + static_cast<Index>(images.size()), 2);
    places_.topRows(count_) = wrapped;
    for (const auto& [at, source] : images) {
      places_.row(slots()) << at.x, at.y;
      images_.push_back(static_cast<std::int32_t>(source));
    }
  }
  grid.build(periodic() ? places_ : particles.position, support_, particles.threads);
  columns.resize(slots());
}

Neighbourhood FluidArrangement::neighbourhood(const Vector& r, Index i) const {
  Neighbourhood near{.support = support_,
                     .cell = grid.cell(),
                     .origin = grid.origin(),
                     .visited = grid.visited(r),
                     .candidates = {},
                     .neighbours = {}};
  grid.candidates(r, [&](Index first, Index last) {
    for (Index slot = first; slot < last; ++slot) {
      const Index j = id(slot);
      if (j == i) continue;
      near.candidates.push_back(j);
      if (norm(r - columns.position(slot)) < support_) near.neighbours.push_back(j);
    }
  });
  return near;
}

Index FluidArrangement::slot_of(Index particle) const {
  Index slot = 0;
  while (slot + 1 < slots() && grid.id(slot) != particle) ++slot;
  return slot;
}

void add_seen(KernelAround& seen, const Vector& r, const CellGrid& grid, const FluidColumns& columns,
              bool wall) {
  grid.candidates(r, [&](Index first, Index last) {
    for (Index slot = first; slot < last; ++slot) {
      const Vector separation = r - columns.position(slot);
      if (norm(separation) < seen.support)
        seen.neighbours.push_back({.separation = separation, .volume = columns.volume(slot), .wall = wall});
    }
  });
}

PairCount FluidArrangement::count_pairs() const {
  PairCount count;
  for (Index slot = 0; slot < slots(); ++slot) {
    if (is_image(slot)) continue;
    const Vector r = columns.position(slot);
    grid.candidates(r, [&](Index first, Index last) { count.candidates += last - first; });
    packs_near(grid, columns.x.data(), columns.y.data(), r, support_,
               [&](Run, const Vec<Pack>&, const Pack& r2) {
                 count.neighbours += popcount(r2 < support_ * support_);
               });
    --count.candidates;  // itself
    --count.neighbours;
  }
  return count;
}

std::size_t FluidArrangement::bytes() const {
  return grid.bytes() + columns.bytes() + images_.capacity() * sizeof(std::int32_t) +
         static_cast<std::size_t>(places_.size()) * sizeof(double);
}

}  // namespace clapotis
