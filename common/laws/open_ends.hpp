#pragma once

#include <functional>
#include <optional>
#include <vector>

#include "common/simulation/system.hpp"

namespace clapotis {

/// A strip in which liquid comes in. Its particles stand in rows along the flow and move on as they are:
/// neither velocity nor density changes before they have left it. When the last of a row has moved on by a
/// spacing, another like it is put behind it; so a profile that the strip begins with is kept for good, with
/// nothing to remember.
struct Inlet {
  Vector rear;           ///< the corner of the strip where its rows begin and are counted from [L]
  Vector along, across;  ///< unit vectors: of the flow, and from row to row
  double length, width;  ///< of the strip, along and across; at least the kernel's support long [L]
  double spacing;        ///< of particles along a row, and between rows [L]

  [[nodiscard]] bool contains(const Vector& r) const {
    const Vector d = r - rear;
    const double a = dot(d, along), b = dot(d, across);
    return a < length && a > -spacing && b > 0 && b < width;
  }
};

/// A box, of which any side may be infinite [L].
struct Bounds {
  double left, right, bottom, top;

  [[nodiscard]] bool contains(const Vector& r) const {
    return r.x > left && r.x < right && r.y > bottom && r.y < top;
  }
};

/// Liquid beyond `flow` moves on as it is; beyond `all` it is taken out. Between the two lies one support of
/// the kernel, so that nobody in the flow lacks neighbours.
struct Outlet {
  Bounds flow, all;
};

/// Where liquid comes in and goes out, for continuous flows. What enters brings its energy, what leaves takes
/// it away, and so does what holds a particle to its velocity; all this is counted as dissipated, so that the
/// total stays a budget. Mass is counted in particles: those at the start and those that entered are those
/// that left and those that are there.
class OpenEnds {
 public:
  OpenEnds() = default;  ///< none
  OpenEnds(std::vector<Inlet> inlets, std::optional<Outlet> outlet)
      : inlets_(std::move(inlets)), outlet_(outlet) {}

  [[nodiscard]] bool exist() const { return !inlets_.empty() || outlet_; }
  /// Whether a particle at r moves on with the velocity and the density that it has.
  [[nodiscard]] bool hold(const Vector& r) const {
    for (const auto& inlet : inlets_)
      if (inlet.contains(r)) return true;
    return outlet_ && !outlet_->flow.contains(r);
  }
  /// After a step: takes out what has left, fills the rows of the inlets. `energy_of(i)` is the energy of a
  /// particle. One that is faster than `fastest` does not leave: it is wrong, and to be found [L/s].
  void renew(System& s, double fastest, const std::function<double(Index)>& energy_of) const;

 private:
  void take_out(System& s, double fastest, const std::function<double(Index)>& energy_of) const;
  void feed(System& s, const Inlet& inlet, const std::function<double(Index)>& energy_of) const;

  std::vector<Inlet> inlets_;
  std::optional<Outlet> outlet_;
};

}  // namespace clapotis
