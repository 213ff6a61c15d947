#include "common/neighbours/cell_grid.hpp"

#include <algorithm>
#include <cmath>

namespace clapotis {
namespace {

/// The line of cells at or below `least`: cells stand still while the particles move.
double anchor(double least, double side) {
  const double line = std::floor(least / side) * side;
  return line <= least && least - line <= side ? line : least;  // far away, lines are rounded by many cells
}

}  // namespace

void CellGrid::lay_out(const Vectors& position, double support) {
  const double n = static_cast<double>(position.rows());
  Vector low{0, 0}, high{0, 0};
  if (n > 0) {  // a NaN changes neither, unless all are
    low = {position.col(0).minCoeff<Eigen::PropagateNumbers>(),
           position.col(1).minCoeff<Eigen::PropagateNumbers>()};
    high = {position.col(0).maxCoeff<Eigen::PropagateNumbers>(),
            position.col(1).maxCoeff<Eigen::PropagateNumbers>()};
  }
  const double width = high.x - low.x, height = high.y - low.y;
  const double most_cells = 4 * n + 64;
  height_ = reach_ = support * (1 + 1e-6);  // so that round-off cannot hide a neighbour
  if (!std::isfinite(width) || !std::isfinite(height)) {
    origin_ = {0, 0};
    columns_ = lines_ = 1;
    inverse_width_ = inverse_height_ = 0;
    return;
  }
  int slices = slices_;
  const auto cells = [&] { return (width * slices / height_ + 2) * (height / height_ + 2); };
  while (slices > 1 && cells() > most_cells) slices /= 2;
  while (cells() > most_cells) height_ *= 2;
  width_ = height_ / slices;
  inverse_width_ = 1 / width_;
  inverse_height_ = 1 / height_;
  origin_ = {anchor(low.x, width_), anchor(low.y, height_)};
  columns_ = static_cast<Index>((high.x - origin_.x) * inverse_width_) + 1;
  lines_ = static_cast<Index>((high.y - origin_.y) * inverse_height_) + 1;
}

void CellGrid::build(const Vectors& position, double support, int /*threads*/) {
  lay_out(position, support);
  const auto n = static_cast<std::size_t>(position.rows());
  cell_of_.resize(n);
  order_.resize(n);
  starts_.assign(static_cast<std::size_t>(columns_ * lines_) + 1, 0);

  const double *x = position.col(0).data(), *y = position.col(1).data();
  for (std::size_t i = 0; i < n; ++i) {
    const Index cell = place(y[i] - origin_.y, inverse_height_, lines_) * columns_ +
                       place(x[i] - origin_.x, inverse_width_, columns_);
    cell_of_[i] = static_cast<std::int32_t>(cell);
    ++starts_[static_cast<std::size_t>(cell)];
  }
  std::int32_t total = 0;
  for (auto& start : starts_) total = start = total + start;  // now the end of each cell
  for (std::size_t i = n; i-- > 0;)
    order_[static_cast<std::size_t>(--starts_[static_cast<std::size_t>(cell_of_[i])])] =
        static_cast<std::int32_t>(i);
}

std::size_t CellGrid::bytes() const {
  return (starts_.capacity() + cell_of_.capacity() + order_.capacity()) * sizeof(std::int32_t);
}

}  // namespace clapotis
