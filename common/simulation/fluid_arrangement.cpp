#include "common/simulation/fluid_arrangement.hpp"

#include <cmath>

#include "common/neighbours/packs_near.hpp"

namespace clapotis {

/// Along x first, then along y of everything there is by then: corners get theirs.
void FluidArrangement::add_images(int axis) {
  const Index before = slots();
  std::vector<Vector> places;
  for (Index k = 0; k < before; ++k) {
    const Vector r = row(places_, k);
    const auto source =
        k >= count_ ? images_[static_cast<std::size_t>(k - count_)] : static_cast<std::int32_t>(k);
    for (const Vector& shift : period_.shifts(r, axis, support_)) {
      places.push_back(r + shift);
      images_.push_back(source);
    }
  }
  Vectors all(slots(), 2);
  all.topRows(before) = places_;
  for (Index k = before; k < slots(); ++k) {
    const Vector& r = places[static_cast<std::size_t>(k - before)];
    all.row(k) << r.x, r.y;
  }
  places_ = std::move(all);
}

void FluidArrangement::sort(const Particles& particles) {
  count_ = particles.size();
  images_.clear();
  if (periodic()) {  // an integrator may have carried some beyond the edge, where they would see no images
    places_ = particles.position;
    period_.wrap(places_);
    add_images(0);
    add_images(1);
  }
  grid.build(periodic() ? places_ : particles.position, support_, particles.threads);
  columns.resize(slots());
}

Neighbourhood FluidArrangement::neighbourhood(const Vector& r, Index i) const {
  Neighbourhood near{
      .support = support_, .cell = grid.cell(), .origin = grid.origin(), .candidates = {}, .neighbours = {}};
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
