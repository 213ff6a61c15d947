#pragma once

#include <vector>

#include "common/particles/particles.hpp"

namespace clapotis {

/// A plane that repeats itself along x, y or both; 0 where it does not.
struct Period {
  Vector corner{0, 0};  ///< lower left of the cell that repeats [L]
  Vector length{0, 0};  ///< [L]

  /// Brings back what has left the cell.
  void wrap(Vectors& position) const;
  /// Where images of something at r stand, seen from r, along one axis (0: x, 1: y): beyond the opposite
  /// edge, if r is nearer to an edge than `reach`; two in a cell of less than twice that.
  [[nodiscard]] std::vector<Vector> shifts(const Vector& r, int axis, double reach) const;
};

}  // namespace clapotis
