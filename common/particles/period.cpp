#include "common/particles/period.hpp"

#include <cmath>

namespace clapotis {

void Period::wrap(Vectors& position) const {
  for (const int axis : {0, 1}) {
    const double first = axis == 0 ? corner.x : corner.y, side = axis == 0 ? length.x : length.y;
    if (side > 0) position.col(axis) -= ((position.col(axis) - first) / side).floor() * side;
  }
}

std::vector<Image> Period::images(const Vectors& places, double reach) const {
  const Index n = places.rows();
  std::vector<Image> all;
  for (const int axis : {0, 1}) {
    const double first = axis == 0 ? corner.x : corner.y, side = axis == 0 ? length.x : length.y;
    if (side == 0) continue;
    const Index before = n + static_cast<Index>(all.size());
    for (Index k = 0; k < before; ++k) {
      const Image original = k < n ? Image{row(places, k), k} : all[static_cast<std::size_t>(k - n)];
      const double at = axis == 0 ? original.at.x : original.at.y;
      const auto add = [&](double shift) {
        all.push_back({original.at + (axis == 0 ? Vector{shift, 0} : Vector{0, shift}), original.source});
      };
      if (at < first + reach) add(side);
      if (at >= first + side - reach) add(-side);
    }
  }
  return all;
}

}  // namespace clapotis
