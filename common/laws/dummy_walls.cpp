#include "common/laws/dummy_walls.hpp"

#include <algorithm>
#include <cmath>

namespace clapotis {

DummyWalls::DummyWalls(const Vectors& particles, const Fluid& fluid, double support, const Period& period) {
  const auto images = period.images(particles, support);
  const Index given = particles.rows(), n = given + static_cast<Index>(images.size());
  Vectors unsorted(n, 2);
  unsorted.topRows(given) = particles;
  for (Index k = given; k < n; ++k) {
    const Vector& at = images[static_cast<std::size_t>(k - given)].at;
    unsorted.row(k) << at.x, at.y;
  }
  grid.build(unsorted, support, 1);
  places.resize(n, 2);
  std::vector<Index> slot_of(static_cast<std::size_t>(n));
  for (Index slot = 0; slot < n; ++slot) {
    places.row(slot) = unsorted.row(grid.id(slot));
    slot_of[static_cast<std::size_t>(grid.id(slot))] = slot;
  }
  for (Index k = given; k < n; ++k)
    images_.push_back(
        {slot_of[static_cast<std::size_t>(k)],
         slot_of[static_cast<std::size_t>(images[static_cast<std::size_t>(k - given)].source)]});
  columns.resize(n);
  columns.x.head(n) = places.col(0);
  columns.y.head(n) = places.col(1);
  columns.vx.head(n) = columns.vy.head(n) = columns.pressure.head(n) = 0;
  columns.density.head(n) = fluid.state.reference_density;
  columns.volume.head(n) = fluid.mass / fluid.state.reference_density;
  sliding_ = Column::Zero(columns.x.size());
  if (n > 0) mark_reached(support);
}

void DummyWalls::slide_above(double y, double speed) {
  for (Index slot = 0; slot < size(); ++slot)
    if (places(slot, 1) > y) sliding_(slot) = speed;
}

void DummyWalls::copy_to_images() {
  for (const auto& [image, source] : images_)
    for (Column* column : {&columns.pressure, &columns.vx, &columns.vy}) (*column)(image) = (*column)(source);
}

std::size_t DummyWalls::bytes() const {
  return columns.bytes() + grid.bytes() + reached_.size() + images_.capacity() * sizeof(Copy) +
         static_cast<std::size_t>(sliding_.size()) * sizeof(double);
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

Index wall_layers(double spacing, double support) {
  return static_cast<Index>(std::ceil(support / spacing - 1e-9));
}

double wall_thickness(double spacing, double support) {
  return static_cast<double>(wall_layers(spacing, support)) * spacing;
}

Vectors tank_walls(double left, double right, double bottom, double top, double spacing, double support) {
  const Index layers = wall_layers(spacing, support);
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
