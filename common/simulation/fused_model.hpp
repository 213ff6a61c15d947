#pragma once

#include <tuple>

#include "common/laws/law.hpp"
#include "common/neighbours/all_pairs.hpp"
#include "common/simulation/law_set.hpp"
#include "common/simulation/phase_timer.hpp"
#include "common/simulation/sweep.hpp"
#include "common/simulation/system.hpp"

namespace clapotis {

/// In place of a neighbour search, for scenes whose particles do not act on each other.
struct NoPairs {};

/// The laws of a scene, fused: one sweep over the neighbours computes all pair laws, one pass all others.
/// What no law needs is not there: without a pair law no neighbours are searched, without a law that
/// dissipates nothing is summed. `Search` is AllPairs, CellGrid or NoPairs; `Mass` is UniformMass or
/// StoredMass.
template <class Search, class Mass, Law... Laws>
class FusedModel final : public Model {
  static constexpr bool pairs = (ActsOnPair<Laws> || ...);
  static_assert(
      pairs != std::is_same_v<Search, NoPairs>,
      "A scene with a law between pairs names its neighbour search, AllPairs or CellGrid; one without such "
      "a law says NoPairs.");
  struct Nothing {};
  using PairSweep = Sweep<std::conditional_t<pairs, Search, AllPairs>, Mass,
                          ((ActsOnPair<Laws> && ReadsVelocity<Laws>) || ...)>;

 public:
  explicit FusedModel(Parameters& parameters) : laws_(parameters) {}

  void evaluate(System& s, double t) override {
    accelerate<Laws...>(s.particles, t, s.acceleration);
    s.dissipation = laws_.dissipation(s.particles, t);
  }
  void settle(System& s, double dt) override { laws_.settle(s, dt); }
  void refresh(Parameters& parameters) override { laws_.refresh(parameters); }

  [[nodiscard]] StoredEnergy stored_energy(const Particles& particles) override {
    StoredEnergy energy{.potential = laws_.potential(particles)};
    if constexpr (pairs) energy.elastic = pair_energy(particles);
    return energy;
  }
  [[nodiscard]] std::vector<StepLimit> limits(const Particles& particles) const override {
    return laws_.limits(particles);
  }
  [[nodiscard]] std::vector<std::string> laws() const override { return laws_.names(); }
  [[nodiscard]] std::optional<Walls> walls() const override { return laws_.walls(); }

  [[nodiscard]] std::vector<double> law_seconds(const System& s, int repetitions) override;
  [[nodiscard]] std::optional<Neighbourhood> neighbourhood(const Particles& particles, Index i) override;
  [[nodiscard]] std::vector<ActingLaw> accelerations_by_law(const System& s, Index i) override;
  [[nodiscard]] double push_at(double r, Index i) override;
  [[nodiscard]] PairCount count_pairs(const Particles& particles) override;
  [[nodiscard]] bool has_pairs() const override { return pairs; }
  [[nodiscard]] std::size_t bytes() const override {
    if constexpr (pairs)
      return sweep_.bytes();
    else
      return 0;
  }

 private:
  [[nodiscard]] double support() const {
    double widest = 0;
    laws_.each([&](const auto& law) {
      if constexpr (requires { law.support(); }) widest = std::max(widest, law.support());
    });
    return widest;
  }

  /// Acceleration of every particle by the laws `Some`.
  template <class... Some>
  void accelerate(const Particles& particles, double t, Vectors& a) {
    const auto p = view_of<Mass>(particles);
    const auto bodies = [&](Index i) { return laws_.template body<Some...>(p, i, t); };
    if constexpr ((ActsOnPair<Some> || ...)) {
      {
        const PhaseTimer timer(timed, seconds.neighbours);
        sweep_.build(particles, support());
      }
      const PhaseTimer timer(timed, seconds.forces);
      std::atomic<long long> at_one_point = 0;
      for_each(particles.size(), particles.threads, [&](Slot slot) {
        const Index i = sweep_.search.id(slot);
        const Vector sum = bodies(i) + by_pairs<Some...>(slot, at_one_point);
        a(i, 0) = sum.x;
        a(i, 1) = sum.y;
      });
      coincident += at_one_point / 2;
    } else {
      const PhaseTimer timer(timed, seconds.forces);
      for_each(particles.size(), particles.threads, [&](Index i) {
        const Vector sum = bodies(i);
        a(i, 0) = sum.x;
        a(i, 1) = sum.y;
      });
    }
  }

  /// Acceleration of the particle in `slot` by its neighbours. Flattened: the loop over packs and the laws in
  /// one function, so that sums and constants stay in registers.
  template <class... Some>
  [[gnu::flatten]] Vector by_pairs(Slot slot, std::atomic<long long>& at_one_point) const {
    const auto& p = sweep_.view();
    const auto all_laws = [&](Run j, const Encounter& ij) {
      Vec<Pack> sum{Pack(0.0), Pack(0.0)};
      const auto add = [&](const auto& law) {
        if constexpr (requires { law.pair(p, slot, j, ij); }) sum += law.pair(p, slot, j, ij);
      };
      (add(laws_.template get<Some>()), ...);
      return sum;
    };
    Vec<Pack> packs{Pack(0.0), Pack(0.0)};
    const int others = sweep_.around(slot, [&](Run j, const Encounter& ij) { packs += all_laws(j, ij); });
    Vector a{sum(packs.x), sum(packs.y)};
    if (others > 0) {
      at_one_point += others;
      sweep_.coincident(slot, [&](Run j, const Encounter& ij) {
        const auto lane = all_laws(j, ij);
        a += Vector{lane.x[0], lane.y[0]};
      });
    }
    return a;
  }

  double pair_energy(const Particles& particles) {
    sweep_.build(particles, support());
    const auto& p = sweep_.view();
    return sum_over(particles.size(), particles.threads, [&](Slot slot, std::size_t) {
      const auto all_laws = [&](Run j, const Encounter& ij) {
        Pack sum(0.0);
        laws_.each([&](const auto& law) {
          if constexpr (requires { law.pair_potential(p, slot, j, ij); })
            sum += law.pair_potential(p, slot, j, ij);
        });
        return sum;
      };
      Pack packs(0.0);
      double coincident_energy = 0;
      const int others = sweep_.around(slot, [&](Run j, const Encounter& ij) { packs += all_laws(j, ij); });
      if (others > 0)
        sweep_.coincident(slot, [&](Run j, const Encounter& ij) { coincident_energy += all_laws(j, ij)[0]; });
      return (sum(packs) + coincident_energy) / 2;  // each pair is met twice
    });
  }

  LawSet<Mass, Laws...> laws_;
  [[no_unique_address]] std::conditional_t<pairs, PairSweep, Nothing> sweep_;
};

template <class Search, class Mass, Law... Laws>
std::vector<double> FusedModel<Search, Mass, Laws...>::law_seconds(const System& s, int repetitions) {
  Vectors scratch(s.particles.size(), 2);
  const auto keep = std::tuple(timed, coincident);
  timed = false;
  const std::vector<double> result{
      median_seconds_of(repetitions, [&] { accelerate<Laws>(s.particles, s.time, scratch); })...};
  std::tie(timed, coincident) = keep;
  return result;
}

template <class Search, class Mass, Law... Laws>
std::optional<Neighbourhood> FusedModel<Search, Mass, Laws...>::neighbourhood(const Particles& particles,
                                                                              Index i) {
  if constexpr (!pairs) {
    return std::nullopt;
  } else {
    sweep_.build(particles, support());
    Neighbourhood near{.support = support(),
                       .cell = sweep_.search.cell(),
                       .origin = sweep_.search.origin(),
                       .visited = sweep_.search.visited(row(particles.position, i)),
                       .candidates = {},
                       .neighbours = {}};
    const Vector r = row(particles.position, i);
    sweep_.search.candidates(r, [&](Slot first, Slot last) {
      for (Slot slot = first; slot < last; ++slot) {
        const Index j = sweep_.search.id(slot);
        if (j == i) continue;
        near.candidates.push_back(j);
        if (norm(r - row(particles.position, j)) < near.support) near.neighbours.push_back(j);
      }
    });
    return near;
  }
}

template <class Search, class Mass, Law... Laws>
std::vector<ActingLaw> FusedModel<Search, Mass, Laws...>::accelerations_by_law(const System& s, Index i) {
  const auto p = view_of<Mass>(s.particles);
  return laws_.one_by_one([&]<class L>() {
    Vector a = laws_.template body<L>(p, i, s.time);
    if constexpr (ActsOnPair<L>) {
      std::atomic<long long> uncounted = 0;
      a += by_pairs<L>(sweep_.slot_of(i), uncounted);
    }
    return a;
  });
}

template <class Search, class Mass, Law... Laws>
double FusedModel<Search, Mass, Laws...>::push_at(double r, Index i) {
  double push = 0;
  if constexpr (pairs) {
    const Slot slot = sweep_.slot_of(i);
    const Encounter beside{{Pack(r), Pack(0.0)}, Pack(r), {Pack(1.0), Pack(0.0)}};
    laws_.each([&](const auto& law) {  // its own mass and velocity stand for the other's
      if constexpr (requires { law.support(); })
        if (r < law.support()) push += law.pair(sweep_.view(), slot, Run{slot}, beside).x[0];
    });
  }
  return push;
}

template <class Search, class Mass, Law... Laws>
PairCount FusedModel<Search, Mass, Laws...>::count_pairs(const Particles& particles) {
  PairCount count;
  if constexpr (pairs) {
    sweep_.build(particles, support());
    for (Slot slot = 0; slot < particles.size(); ++slot) {
      sweep_.search.candidates(sweep_.position(slot),
                               [&](Slot first, Slot last) { count.candidates += last - first; });
      const int others = sweep_.around(
          slot, [&](Run, const Encounter& ij) { count.neighbours += popcount(ij.distance < support()); });
      count.neighbours += others;
      --count.candidates;  // itself
    }
  }
  return count;
}

}  // namespace clapotis
