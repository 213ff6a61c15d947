#pragma once

#include <algorithm>
#include <array>

#include "common/laws/law.hpp"
#include "common/neighbours/cell_grid.hpp"

namespace clapotis {

/// Squared distance too small to tell a direction [L^2].
inline constexpr double one_point = 1e-280;

/// Calls meet(j, d, r2) for all packs of particles j that may be within the support of a particle at r, with
/// d = r - r_j and r2 = d^2, where x and y are the positions in the order of the grid. Lanes behind the end
/// of a range are put at r2 = 4 support^2, where every kernel is zero; so is it at any r2 beyond the support.
/// r2 is never below `one_point`, so that 1/r is a number.
///
/// The packs are listed first and met then: one loop of five or six rounds per particle is predicted better
/// than three of two.
template <class Meet>
[[gnu::always_inline]] inline void packs_near(const CellGrid& grid, const double* x, const double* y,
                                              const Vector& r, double support, const Meet& meet) {
  struct Part {
    std::int32_t first, last;
  };
  std::array<Part, 64> parts;
  std::size_t count = 0;
  const Vec<Pack> here{Pack(r.x), Pack(r.y)};
  const Pack beyond(4 * support * support);
  const auto meet_all = [&] {
    for (std::size_t k = 0; k < count; ++k) {
      const Run j{parts[k].first};
      const Vec<Pack> d = here - Vec<Pack>{load(x, j), load(y, j)};
      const auto is_there = lanes < static_cast<double>(parts[k].last - parts[k].first);
      meet(j, d, max(select(is_there, dot(d, d), beyond), one_point));
    }
    count = 0;
  };
  grid.candidates(r, [&](Index first, Index last) {
    for (Index at = first; at < last; at += pack_width) {
      if (count == parts.size()) meet_all();
      parts[count++] = {static_cast<std::int32_t>(at), static_cast<std::int32_t>(last)};
    }
  });
  meet_all();
}

}  // namespace clapotis
