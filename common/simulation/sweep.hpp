#pragma once

#include <atomic>
#include <cmath>
#include <vector>

#include "common/laws/law.hpp"
#include "common/particles/parallel.hpp"

namespace clapotis {

/// One particle of the sweep: its place in the sorted order.
using Slot = Index;

/// The columns that pair laws read, copied into the order of the neighbour search, so that the candidates of
/// a particle are contiguous and a pack of them is one load. Behind the last follows one pack of ones, so
/// that a load never leaves the column: a law computes with them, for nothing, so they must divide and
/// overflow nothing.
template <class Search, class Mass, bool with_velocity>
class Sweep {
 public:
  Search search;

  void build(const Particles& particles, double support) {
    support_ = support;
    search.build(particles.position, support, particles.threads);
    n_ = particles.size();
    gather(x_, particles.position.col(0).data(), far_away, particles.threads);
    gather(y_, particles.position.col(1).data(), far_away, particles.threads);
    if constexpr (with_velocity) {
      gather(vx_, particles.velocity.col(0).data(), 0, particles.threads);
      gather(vy_, particles.velocity.col(1).data(), 0, particles.threads);
    }
    if constexpr (std::is_same_v<Mass, StoredMass>)
      gather(mass_, particles.column("mass")->data(), 1, particles.threads);
    view_ = make_view(particles);
  }

  [[nodiscard]] const auto& view() const { return view_; }
  [[nodiscard]] Vector position(Slot i) const { return {x_(i), y_(i)}; }
  /// Where a particle is; it is there, since `build` had it.
  [[nodiscard]] Slot slot_of(Index particle) const {
    Slot slot = 0;
    while (slot + 1 < n_ && search.id(slot) != particle) ++slot;
    return slot;
  }

  /// Calls meet(j, ij) for the packs of particles that may act on the one in `slot`. Lanes that hold itself,
  /// or a particle beyond the support, are given a distance of twice the support, where no law acts; their
  /// separation is as it is. Returns how many others are at its very place; those are the caller's to deal
  /// with (`coincident`).
  template <class Meet>
  int around(Slot slot, const Meet& meet) const {
    const Vec<Pack> r{Pack(x_(slot)), Pack(y_(slot))};
    const double support2 = support_ * support_;
    int at_one_point = -1;  // itself
    search.candidates(position(slot), [&](Slot first, Slot last) {
      for (Slot at = first; at < last; at += pack_width) {
        const Run j{at};
        const Vec<Pack> d = r - Vec<Pack>{load(x_.data(), j), load(y_.data(), j)};
        const Pack d2 = dot(d, d);
        const auto near = d2 < support2 && lanes < static_cast<double>(last - at);
        if (none_of(near)) continue;
        const auto apart = d2 > one_point;
        at_one_point += popcount(near && !apart);
        const Pack distance2 = select(near && apart, d2, Pack(4 * support2));
        const Pack inverse = inverse_sqrt(distance2);
        meet(j, Encounter{d, distance2 * inverse, inverse * d});
      }
    });
    return std::max(at_one_point, 0);  // a particle without a position is not even where it is itself
  }

  /// Calls meet(j, ij) for each other particle at the very place of the one in `slot`; only lane 0 counts.
  /// The direction follows from the two ids, opposite for the other of the two.
  template <class Meet>
  void coincident(Slot slot, const Meet& meet) const {
    search.candidates(position(slot), [&](Slot first, Slot last) {
      for (Slot j = first; j < last; ++j) {
        const double dx = x_(slot) - x_(j), dy = y_(slot) - y_(j);
        if (j == slot || dx * dx + dy * dy > one_point) continue;
        const Vector u = direction_of(search.id(slot), search.id(j));
        meet(Run{j}, Encounter{{Pack(0.0), Pack(0.0)}, Pack(0.0), {Pack(u.x), Pack(u.y)}});
      }
    });
  }

  [[nodiscard]] std::size_t bytes() const {
    return search.bytes() +
           static_cast<std::size_t>(x_.size() + y_.size() + vx_.size() + vy_.size() + mass_.size()) *
               sizeof(double);
  }

 private:
  static constexpr double far_away = 1e100;    ///< and yet (v d)^2 is a number [L]
  static constexpr double one_point = 1e-300;  ///< squared distance too small to tell a direction [L^2]

  static Vector direction_of(Index a, Index b) {
    const double turn =
        0.7548776662466927 * static_cast<double>(std::min(a, b)) +
        0.5698402909980532 * static_cast<double>(std::max(a, b));  // evenly spread: R2 sequence, Roberts 2018
    const double angle = 2 * M_PI * (turn - std::floor(turn));
    const double sign = a < b ? 1 : -1;
    return {sign * std::cos(angle), sign * std::sin(angle)};
  }

  /// `instead` takes the place of what is not a number: 0 x NaN would reach the others of its pack.
  void gather(Column& sorted, const double* column, double instead, int threads) {
    if (sorted.size() != n_ + pack_width) sorted = Column::Ones(n_ + pack_width);
    for_each(n_, threads, [&](Slot i) {
      const double value = column[search.id(i)];
      sorted(i) = std::isfinite(value) ? value : instead;
    });
  }

  View<Mass, with_velocity> make_view(const Particles& particles) const {
    Mass mass(particles);
    if constexpr (std::is_same_v<Mass, StoredMass>) mass.m = mass_.data();
    return {mass, x_.data(), y_.data(), vx_.data(), vy_.data()};
  }

  Index n_ = 0;
  double support_ = 0;
  Column x_, y_, vx_, vy_, mass_;
  View<Mass, with_velocity> view_;
};

}  // namespace clapotis
