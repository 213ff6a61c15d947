#include "common/particles/period.hpp"

#include <cmath>

namespace clapotis {

void Period::wrap(Vectors& position) const {
  for (const int axis : {0, 1}) {
    const double first = axis == 0 ? corner.x : corner.y, side = axis == 0 ? length.x : length.y;
    if (side > 0) position.col(axis) -= ((position.col(axis) - first) / side).floor() * side;
  }
}

std::vector<Vector> Period::shifts(const Vector& r, int axis, double reach) const {
  const double first = axis == 0 ? corner.x : corner.y, side = axis == 0 ? length.x : length.y;
  const double at = axis == 0 ? r.x : r.y;
  std::vector<Vector> all;
  if (side == 0) return all;
  const auto shift = [&](double by) { all.push_back(axis == 0 ? Vector{by, 0} : Vector{0, by}); };
  if (at < first + reach) shift(side);
  if (at >= first + side - reach) shift(-side);
  return all;
}

}  // namespace clapotis
