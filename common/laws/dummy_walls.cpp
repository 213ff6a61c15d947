#include "common/laws/dummy_walls.hpp"

#include <algorithm>
#include <cmath>

namespace clapotis {

namespace {

struct Placed {
  Vector at;
  Index source;  ///< of the particles given
};

std::vector<Placed> with_images(const Vectors& particles, double support, const Period& period) {
  std::vector<Placed> all;
  for (Index i = 0; i < particles.rows(); ++i) all.push_back({row(particles, i), i});
  for (const int axis : {0, 1})  // along x first, then along y of everything there is by then
    for (std::size_t k = 0, before = all.size(); k < before; ++k)
      for (const Vector& shift : period.shifts(all[k].at, axis, support))
        all.push_back({all[k].at + shift, all[k].source});
  return all;
}

}  // namespace

DummyWalls::DummyWalls(const Vectors& particles, const Fluid& fluid, double support, const Period& period) {
  const auto all = with_images(particles, support, period);
  const auto n = static_cast<Index>(all.size());
  Vectors unsorted(n, 2);
  for (Index k = 0; k < n; ++k)
    unsorted.row(k) << all[static_cast<std::size_t>(k)].at.x, all[static_cast<std::size_t>(k)].at.y;
  grid.build(unsorted, support, 1);
  places.resize(n, 2);
  std::vector<Index> slot_of(all.size());
  for (Index slot = 0; slot < n; ++slot) {
    places.row(slot) = unsorted.row(grid.id(slot));
    slot_of[static_cast<std::size_t>(grid.id(slot))] = slot;
  }
  sources_.resize(all.size());
  for (Index slot = 0; slot < n; ++slot)
    sources_[static_cast<std::size_t>(slot)] =
        slot_of[static_cast<std::size_t>(all[static_cast<std::size_t>(grid.id(slot))].source)];
  has_images_ = n > particles.rows();
  columns.resize(n);
  columns.x.head(n) = places.col(0);
  columns.y.head(n) = places.col(1);
  columns.vx.head(n) = columns.vy.head(n) = columns.pressure.head(n) = 0;
  columns.density.head(n) = fluid.state.reference_density;
  columns.volume.head(n) = fluid.mass / fluid.state.reference_density;
  own_x_ = own_y_ = Column::Zero(columns.x.size());
  if (n > 0) mark_reached(support);
}

void DummyWalls::slide_above(double y, double speed) {
  for (Index slot = 0; slot < size(); ++slot)
    if (places(slot, 1) > y) own_x_(slot) = speed;
}

void DummyWalls::copy_to_images() {
  if (!has_images_) return;
  for (Index slot = 0; slot < size(); ++slot) {
    const Index source = sources_[static_cast<std::size_t>(slot)];
    for (Column* column : {&columns.pressure, &columns.vx, &columns.vy}) (*column)(slot) = (*column)(source);
  }
}

/// A cell is within reach when a wall particle is in it or in one of the eight around.
void DummyWalls::mark_reached(double support) {
  const Index n = size();
  const double side = support * (1 + 1e-6);
  inverse_side_ = 1 / side;
  corner_ = {columns.x.head(n).minCoeff() - 2 * side, columns.y.head(n).minCoeff() - 2 * side};
  columns_ = std::floor((columns.x.head(n).maxCoeff() - corner_.x) * inverse_side_) + 3;
  lines_ = std::floor((columns.y.head(n).maxCoeff() - corner_.y) * inverse_side_) + 3;
  const auto across = static_cast<std::size_t>(columns_);
  reached_.assign(across * static_cast<std::size_t>(lines_), 0);
  for (Index slot = 0; slot < n; ++slot) {
    const auto column = static_cast<std::size_t>((columns.x(slot) - corner_.x) * inverse_side_);
    const auto line = static_cast<std::size_t>((columns.y(slot) - corner_.y) * inverse_side_);
    for (auto l = line - 1; l <= line + 1; ++l)
      for (auto c = column - 1; c <= column + 1; ++c) reached_[l * across + c] = 1;
  }
}

Vectors tank_walls(double left, double right, double bottom, double top, double spacing, double support) {
  const auto layers = static_cast<Index>(std::ceil(support / spacing - 1e-9));
  const auto across = static_cast<Index>(std::lround((right - left) / spacing)) + 2 * layers;
  const auto up = static_cast<Index>(std::lround((top - bottom) / spacing)) + layers;
  const double pitch = (right - left) / static_cast<double>(across - 2 * layers);
  std::vector<Vector> all;
  for (Index line = 0; line < up; ++line)
    for (Index column = 0; column < across; ++column) {
      if (line >= layers && column >= layers && column < across - layers) continue;
      all.push_back({left + pitch * (static_cast<double>(column - layers) + 0.5),
                     bottom + spacing * (static_cast<double>(line - layers) + 0.5)});
    }
  Vectors places(static_cast<Index>(all.size()), 2);
  for (Index i = 0; i < places.rows(); ++i)
    places.row(i) << all[static_cast<std::size_t>(i)].x, all[static_cast<std::size_t>(i)].y;
  return places;
}

}  // namespace clapotis
