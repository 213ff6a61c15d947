#include "common/neighbours/cell_grid.hpp"

#include <algorithm>
#include <cmath>

namespace clapotis {

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
  cell_ = support * (1 + 1e-6);  // so that round-off cannot put two neighbours two cells apart
  if (!std::isfinite(width) || !std::isfinite(height)) {
    origin_ = {0, 0};
    columns_ = lines_ = 1;
    inverse_cell_ = 0;
    return;
  }
  while ((width / cell_ + 2) * (height / cell_ + 2) > most_cells) cell_ *= 2;
  inverse_cell_ = 1 / cell_;
  const auto anchor = [&](double least) {  // cells that stand still while the particles move
    const double line = std::floor(least * inverse_cell_) * cell_;
    return line <= least && least - line <= cell_ ? line
                                                  : least;  // far away, lines are rounded by many cells
  };
  origin_ = {anchor(low.x), anchor(low.y)};
  columns_ = static_cast<Index>((high.x - origin_.x) * inverse_cell_) + 1;
  lines_ = static_cast<Index>((high.y - origin_.y) * inverse_cell_) + 1;
}

void CellGrid::build(const Vectors& position, double support, int /*threads*/) {
  lay_out(position, support);
  const auto n = static_cast<std::size_t>(position.rows());
  cell_of_.resize(n);
  order_.resize(n);
  starts_.assign(static_cast<std::size_t>(columns_ * lines_) + 1, 0);

  const double *x = position.col(0).data(), *y = position.col(1).data();
  for (std::size_t i = 0; i < n; ++i) {
    const Index cell = place(y[i] - origin_.y, lines_) * columns_ + place(x[i] - origin_.x, columns_);
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
