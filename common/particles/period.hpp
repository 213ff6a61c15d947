#pragma once

#include <vector>

#include "common/particles/particles.hpp"

namespace clapotis {

/// What appears a second time in a periodic plane.
struct Image {
  Vector at;     ///< [L]
  Index source;  ///< the row of what it is an image of
};

/// A plane that repeats itself along x, y or both; 0 where it does not.
struct Period {
  Vector corner{0, 0};  ///< lower left of the cell that repeats [L]
  Vector length{0, 0};  ///< [L]

  /// Brings back what has left the cell.
  void wrap(Vectors& position) const;
  /// The images, beyond the opposite edge, of all that is nearer to an edge than `reach`: along x first, then
  /// along y of everything there is by then, so that corners get theirs.
  [[nodiscard]] std::vector<Image> images(const Vectors& places, double reach) const;
};

}  // namespace clapotis
