#include "common/neighbours/cell_grid.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <utility>

#include "common/particles/parallel.hpp"

namespace clapotis {
namespace {

/// The line of cells at or below `least`: cells stand still while the particles move.
double anchor(double least, double side) {
  const double line = std::floor(least / side) * side;
  return line <= least && least - line <= side ? line : least;  // far away, lines are rounded by many cells
}

struct Extent {
  Vector low, high;
};

/// The part of n things that is the share of one out of `shares`.
struct Share {
  Index first, last;
};
Share share_of(Index n, Index share, Index shares) { return {n * share / shares, n * (share + 1) / shares}; }

/// What the particles cover. A NaN changes it as little as one particle less, unless all are.
Extent extent(const Vectors& position, int shares) {
  if (position.rows() < shares) return {};
  std::vector<Extent> parts(static_cast<std::size_t>(shares));
  for_each_block(shares, shares, [&](Index share) {
    const auto [first, last] = share_of(position.rows(), share, shares);
    const auto x = position.col(0).segment(first, last - first),
               y = position.col(1).segment(first, last - first);
    parts[static_cast<std::size_t>(share)] = {
        {x.minCoeff<Eigen::PropagateNumbers>(), y.minCoeff<Eigen::PropagateNumbers>()},
        {x.maxCoeff<Eigen::PropagateNumbers>(), y.maxCoeff<Eigen::PropagateNumbers>()}};
  });
  Extent all = parts.front();
  for (const auto& [low, high] : parts) {  // fmin and fmax pass over a NaN
    all.low = {std::fmin(all.low.x, low.x), std::fmin(all.low.y, low.y)};
    all.high = {std::fmax(all.high.x, high.x), std::fmax(all.high.y, high.y)};
  }
  return all;
}

}  // namespace

void CellGrid::lay_out(const Vectors& position, double support, int shares) {
  const double n = static_cast<double>(position.rows());
  const auto [low, high] = extent(position, shares);
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

/// Counting sort. Each share of the particles counts by itself how many it has in every cell; then the cells
/// are laid one after the other, in each the shares in their order, and every share fills its own places. So
/// the order within a cell is that of the particles, with any number of shares. The last share counts in
/// `starts_`, one entry ahead: when its places are filled, each entry is where the next cell starts.
void CellGrid::build(const Vectors& position, double support, int threads) {
  const Index n = position.rows();
  const int shares = threads_for_little(n, threads);
  lay_out(position, support, shares);
  const Index cells = columns_ * lines_;
  cell_of_.resize(static_cast<std::size_t>(n));
  order_.resize(static_cast<std::size_t>(n));
  starts_.resize(static_cast<std::size_t>(cells) + 1);
  starts_[0] = 0;
  counts_.resize(static_cast<std::size_t>((shares - 1) * cells));
  const auto counts = [&](Index share) {
    return share + 1 == shares ? starts_.data() + 1 : counts_.data() + share * cells;
  };

  const double *x = position.col(0).data(), *y = position.col(1).data();
  for_each_block(shares, shares, [&](Index share) {
    auto* count = counts(share);
    std::fill(count, count + cells, 0);
    const auto [first, last] = share_of(n, share, shares);
    for (Index i = first; i < last; ++i) {
      const Index cell = place(y[i] - origin_.y, inverse_height_, lines_) * columns_ +
                         place(x[i] - origin_.x, inverse_width_, columns_);
      cell_of_[static_cast<std::size_t>(i)] = static_cast<std::int32_t>(cell);
      ++count[cell];
    }
  });
  std::vector<std::int32_t> totals(static_cast<std::size_t>(shares) + 1, 0);  // in each share of the cells
  if (shares > 1) {
    for_each_block(shares, shares, [&](Index part) {
      const auto [first, last] = share_of(cells, part, shares);
      auto& total = totals[static_cast<std::size_t>(part) + 1];
      for (Index share = 0; share < shares; ++share)
        total = std::accumulate(counts(share) + first, counts(share) + last, total);
    });
    std::partial_sum(totals.begin(), totals.end(), totals.begin());
  }
  for_each_block(shares, shares, [&](Index part) {
    std::int32_t total = totals[static_cast<std::size_t>(part)];
    const auto [first, last] = share_of(cells, part, shares);
    for (Index c = first; c < last; ++c)
      for (Index share = 0; share < shares; ++share) total += std::exchange(counts(share)[c], total);
  });
  for_each_block(shares, shares, [&](Index share) {
    auto* next = counts(share);
    const auto [first, last] = share_of(n, share, shares);
    for (Index i = first; i < last; ++i)
      order_[static_cast<std::size_t>(next[cell_of_[static_cast<std::size_t>(i)]]++)] =
          static_cast<std::int32_t>(i);
  });
}

Corners CellGrid::visited(Vector r) const {
  const auto along = [this](double x) { return static_cast<double>(place(x, inverse_width_, columns_)); };
  const double x = r.x - origin_.x, lines = static_cast<double>(lines_);
  const auto line = static_cast<double>(place(r.y - origin_.y, inverse_height_, lines_));
  return {origin_ + Vector{along(x - reach_) * width_, std::max(line - 1, 0.0) * height_},
          origin_ + Vector{(along(x + reach_) + 1) * width_, std::min(line + 2, lines) * height_}};
}

std::size_t CellGrid::bytes() const {
  return (starts_.capacity() + counts_.capacity() + cell_of_.capacity() + order_.capacity()) *
         sizeof(std::int32_t);
}

}  // namespace clapotis
