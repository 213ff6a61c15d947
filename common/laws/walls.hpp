#pragma once

#include <limits>

#include "common/laws/law.hpp"
#include "common/simulation/quantities.hpp"

namespace clapotis {

/// Where the centres of the particles may be: left <= x <= right, bottom <= y <= top (any may be infinite)
/// [L]. At a wall the normal velocity is turned round and multiplied by e; the tangential one is kept.
struct Walls {
  double left, right, bottom, top;
  double restitution;  ///< e, 0 to 1

  [[nodiscard]] double low(int axis) const { return axis == 0 ? left : bottom; }
  [[nodiscard]] double high(int axis) const { return axis == 0 ? right : top; }

  /// Brings back one particle that a step carried beyond a wall: to the wall, the velocity turned round. The
  /// speed that is turned round is the one it passed the wall with, v_w^2 = v^2 - 2 a depth, where `a` is its
  /// acceleration; with a = 0 it is the one it arrived with. One that went further than a whole box ends
  /// where its reflections put it (see `fold`). Each axis by itself, so that a corner gives both normals
  /// once, in any order. Returns the energy per unit of mass that the impact takes, and counts folds.
  double clamp(Vector& r, Vector& v, const Vector& a, double dt, long long& folded) const;
};

/// Throws BadInput when (x0, y0), which is `margin` below and left of a disc's centre, is outside the walls.
void require_inside(Parameters& p, const Walls& walls, double margin = 0);

/// One coordinate of a particle that flew freely for the time `dt` and was reflected at `low` and `high` on
/// its way.
struct Folded {
  double position, velocity;
  double impacts;  ///< how many, possibly very many
};

/// From `start` (inside) with velocity v for the time dt between two walls with restitution e, in closed
/// form: the k-th crossing of the box takes (high - low)/(|v| e^k), a geometric series. With e = 1 only the
/// parity counts.
Folded fold(double start, double v, double dt, double low, double high, double e);

/// From a wall, with a speed v >= 0 away from it, under a constant acceleration a > 0 towards it, for the
/// time dt: hop after hop, each e times as long as the one before, a geometric series. Position is the
/// distance from the wall, velocity away from it. It stands still when all hops are over.
Folded hop(double v, double a, double dt, double e);

/// The four walls of the window: the rim of a disc touches them. Handout, section III.
struct BoxWalls {
  static constexpr std::string_view name = "walls";
  Walls walls;

  static BoxWalls from(Parameters& p);
  void settle(System& system, double dt) const;
};
static_assert(Law<BoxWalls> && Settles<BoxWalls>);

/// The four walls for many discs, which press each other on the floor. A disc that is turned round with the
/// speed it passed the wall with stays at rest under any weight (to round-off with symplectic Euler, nearly
/// with Verlet); turned round as in BoxWalls it would shake with the speed a dt, and the floor would feed in
/// m a^2 dt/2 each second: 12 % of the energy of the scene cloud in 5 s, against 5 %.
struct SupportingWalls {
  static constexpr std::string_view name = "walls";
  Walls walls;

  static SupportingWalls from(Parameters& p);
  void settle(System& system, double dt) const;
};
static_assert(Law<SupportingWalls> && Settles<SupportingWalls>);

/// The floor and the side walls of a tank without a lid. Where its walls are made of particles (DummyWalls)
/// these planes, at the walls' faces, are only the last net for what has passed between them; where they are
/// not, the discs of radius dx/2 are reflected at them.
struct TankWalls {
  static constexpr std::string_view name = "walls";
  Walls walls;

  static TankWalls from(Parameters& p);
  void settle(System& system, double dt) const;
};
static_assert(Law<TankWalls> && Settles<TankWalls>);

/// A floor that the CENTRE touches at y = 0, with side walls likewise, and no ceiling: so that the closed
/// form of a vertical fall holds as printed.
struct CentreFloor {
  static constexpr std::string_view name = "walls";
  Walls walls;

  static CentreFloor from(Parameters& p);
  void settle(System& system, double dt) const;
};
static_assert(Law<CentreFloor> && Settles<CentreFloor>);

}  // namespace clapotis
