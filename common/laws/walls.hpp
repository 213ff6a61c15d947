#pragma once

namespace clapotis {

/// Where the centres of the particles may be: left <= x <= right, bottom <= y <= top (any may be infinite) [L].
/// At a wall the normal velocity is turned round and multiplied by `restitution`; the tangential one is kept.
struct Walls {
  double left, right, bottom, top;
  double restitution;  ///< e, 0 to 1

  [[nodiscard]] double low(int axis) const { return axis == 0 ? left : bottom; }
  [[nodiscard]] double high(int axis) const { return axis == 0 ? right : top; }
};

}  // namespace clapotis
