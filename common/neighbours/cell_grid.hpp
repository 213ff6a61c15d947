#pragma once

#include <cstdint>
#include <vector>

#include "common/particles/particles.hpp"

namespace clapotis {

/// Neighbours through a table of cells, at least one support tall: O(n). The particles are put in the order
/// of their cells, row after row (counting sort), so that those near a particle stand in three contiguous
/// ranges, one per row of cells. No cell has a fixed size: all particles may share one.
///
/// Square cells are what the course shows: a particle's own and the eight around it. Cut into `slices` along
/// x, the ranges come closer to what is within the support: 41 candidates instead of 54 for 21 neighbours.
class CellGrid {
 public:
  CellGrid() = default;
  explicit CellGrid(int slices) : slices_(slices) {}

  /// Sorts the particles into cells. The grid covers just the particles; where they are spread so thinly that
  /// cells of one support would outnumber them, the cells grow. Particles without a finite position have no
  /// neighbours.
  void build(const Vectors& position, double support, int threads);

  /// The particle at a place of the sorted order.
  [[nodiscard]] Index id(Index slot) const { return order_[static_cast<std::size_t>(slot)]; }

  /// Calls visit(first, last) for the ranges of slots that may hold neighbours of a particle at r.
  void candidates(Vector r, auto&& visit) const {
    const double x = r.x - origin_.x;
    const Index from = place(x - reach_, inverse_width_, columns_);
    const Index to = place(x + reach_, inverse_width_, columns_);
    const Index line = place(r.y - origin_.y, inverse_height_, lines_);
    for (Index l = std::max<Index>(line - 1, 0); l <= std::min(line + 1, lines_ - 1); ++l)
      visit(start(l * columns_ + from), start(l * columns_ + to + 1));
  }

  [[nodiscard]] Vector cell() const { return {width_, height_}; }  ///< sides of a cell [L]
  [[nodiscard]] Vector origin() const { return origin_; }          ///< lower left corner [L]
  /// The cells that `candidates` of a particle at r are in.
  [[nodiscard]] Corners visited(Vector r) const;
  [[nodiscard]] std::size_t bytes() const;

 private:
  [[nodiscard]] Index start(Index cell) const { return starts_[static_cast<std::size_t>(cell)]; }
  /// Which of `count` cells; also for a distance that is not a number.
  [[nodiscard]] static Index place(double distance, double inverse_side, Index count) {
    const double cells = distance * inverse_side;
    return cells > 0 ? static_cast<Index>(std::min(cells, static_cast<double>(count - 1))) : 0;
  }
  void lay_out(const Vectors& position, double support, int shares);

  Vector origin_{0, 0};
  int slices_ = 1;
  double width_ = 1, height_ = 1, inverse_width_ = 1, inverse_height_ = 1;
  double reach_ = 1;  ///< how far from a particle the ranges go along x [L]
  Index columns_ = 1, lines_ = 1;
  std::vector<std::int32_t> starts_;   ///< first slot of each cell, one more at the end
  std::vector<std::int32_t> counts_;   ///< particles of each cell in all shares but the last
  std::vector<std::int32_t> cell_of_;  ///< of each particle
  std::vector<std::int32_t> order_;    ///< slot -> particle
};

}  // namespace clapotis
