#pragma once

#include <atomic>

#include "common/kernels/kernel.hpp"
#include "common/laws/dummy_walls.hpp"
#include "common/neighbours/packs_near.hpp"
#include "common/simulation/fluid_arrangement.hpp"
#include "common/simulation/implicit_step.hpp"
#include "common/simulation/law_set.hpp"
#include "common/simulation/phase_timer.hpp"

namespace clapotis {

/// Where the density of a fluid comes from.
enum class DensityForm {
  summation,  ///< rho_i = sum_j m W, from the positions alone; it lacks neighbours at a free surface
  continuity  ///< d rho_i/dt = rho_i sum_j V_j v_ij.grad W + diffusion, advanced with the positions
};

/// A weakly compressible liquid (SPH): density, pressure by the Cole equation, walls, and the laws of the
/// scene in one sweep over the neighbours. Every particle gathers its own sum, so there is nothing to lock,
/// and any number of threads gives the same bits. Handout, section VI; Monaghan 2005.
template <class Kernel, Law... Laws>
class FluidModel final : public Model {
 public:
  /// The scene has stated the parameters of `Fluid`. `walls` may be empty; `period` is that of the plane.
  FluidModel(Parameters& p, DensityForm form, DummyWalls walls = {}, const Period& period = {})
      : laws_(p),
        form_(form),
        fluid_(Fluid::from(p)),
        kernel_(fluid_.h),
        sorted_(kernel_.support(), period),
        walls_(std::move(walls)) {
    read(p);
  }

  void evaluate(System& s, double t) override {
    arrange(s.particles);
    if (form_ == DensityForm::summation) {
      const PhaseTimer timer(timed, seconds.density);
      sum_density(s.particles);
    }
    {
      const PhaseTimer timer(timed, seconds.walls);
      wet_walls(s.particles.threads, t);
    }
    const PhaseTimer timer(timed, seconds.forces);
    met_at_one_point_ = 0;
    s.dissipation = accelerate<Laws...>(s.particles, t, s.acceleration) + laws_.dissipation(s.particles, t);
    coincident += met_at_one_point_ / 2;
  }

  void evaluate_density_rate(System& s) override {
    arrange(s.particles);
    const PhaseTimer timer(timed, seconds.density);
    s.diffusion = sum_over(sorted_.slots(), s.particles.threads, [&](Index slot, std::size_t) {
      return sorted_.is_image(slot) ? 0.0 : continuity(slot, s.particles.density_rate);
    });
  }

  void settle(System& s, double dt) override {
    (act_implicitly<Laws>(s, dt), ...);
    laws_.settle(s, dt);
    sorted_.period().wrap(s.position);
  }
  void refresh(Parameters& p) override {
    laws_.refresh(p);
    fluid_ = Fluid::from(p);
    read(p);
  }
  [[nodiscard]] StoredEnergy stored_energy(const Particles& particles) override {
    // a sum of densities is that of the places as they stand, which may have changed since it was taken
    const bool sums = form_ == DensityForm::summation;
    if (sums) arrange(particles);
    return {.potential = laws_.potential(particles),
            .internal = sum_over(
                sums ? sorted_.slots() : particles.size(), particles.threads, [&](Index k, std::size_t) {
                  if (sums && sorted_.is_image(k)) return 0.0;
                  const double density =
                      sums ? fluid_.mass * sum_of_kernels(sorted_.columns.position(k)) : particles.density(k);
                  return fluid_.mass * fluid_.state.energy(density);
                })};
  }
  [[nodiscard]] std::vector<StepLimit> limits(const Particles& particles) const override {
    return laws_.limits(particles);
  }
  [[nodiscard]] bool limits_follow_state() const override { return (FollowsState<Laws> || ...); }
  [[nodiscard]] std::vector<std::string> laws() const override { return laws_.names(); }
  [[nodiscard]] std::optional<Walls> walls() const override { return laws_.walls(); }
  [[nodiscard]] const DummyWalls* wall_particles() const override {
    return walls_.size() > 0 ? &walls_ : nullptr;
  }
  [[nodiscard]] std::vector<double> law_seconds(const System& s, int repetitions) override {
    Vectors scratch(s.particles.size(), 2);
    Particles& particles = const_cast<System&>(s).particles;
    return {median_seconds_of(repetitions, [&] { act_alone<Laws>(particles, s.time, scratch); })...};
  }
  [[nodiscard]] std::optional<Neighbourhood> neighbourhood(const Particles& particles, Index i) override {
    arrange(particles);
    return sorted_.neighbourhood(row(particles.position, i), i);
  }
  [[nodiscard]] PairCount count_pairs(const Particles& particles) override {
    arrange(particles);
    return sorted_.count_pairs();
  }
  [[nodiscard]] bool has_pairs() const override { return true; }
  /// Of the law that acts implicitly, in the last step.
  [[nodiscard]] const Solved& solved() const requires(ActsImplicitly<Laws> || ...) { return solved_; }
  [[nodiscard]] std::size_t bytes() const override { return sorted_.bytes() + walls_.bytes(); }

 private:
  void read(Parameters& p) {
    const auto* g = p.find("gravity");
    gravity_ = {0, g != nullptr ? -g->value : 0};
    if (form_ == DensityForm::continuity)
      diffusion_ =
          2 * fluid_.h * fluid_.state.sound_speed *
          p.number({.name = "delta", .symbol = "delta", .unit = "", .value = 0.1, .range = not_negative});
  }

  void arrange(const Particles& particles) {
    const PhaseTimer timer(timed, seconds.neighbours);
    if (form_ == DensityForm::continuity)
      sorted_.build(particles, [&](Index slot, Index i) { take_density(slot, particles.density(i)); });
    else
      sorted_.build(particles, [](Index, Index) {});
  }

  /// V = m/rho, and p by the Cole equation.
  void take_density(Index slot, double density) {
    auto& c = sorted_.columns;
    c.density(slot) = FluidArrangement::finite_or(density, fluid_.state.reference_density);
    c.volume(slot) = fluid_.mass / c.density(slot);
    c.pressure(slot) = fluid_.state.pressure(c.density(slot));
  }

  /// Calls meet(j, d, r, 1/r) for the packs of fluid particles around r.
  template <class Meet>
  [[gnu::always_inline]] void around(const Vector& r, const Meet& meet) const {
    const auto& c = sorted_.columns;
    packs_near(sorted_.grid, c.x.data(), c.y.data(), r, kernel_.support(), with_distance(meet));
  }
  /// The same for the particles of walls.
  template <class Meet>
  [[gnu::always_inline]] void around_walls(const Vector& r, const Meet& meet) const {
    if (walls_.size() == 0 || !walls_.near(r)) return;
    const auto& c = walls_.columns;
    packs_near(walls_.grid, c.x.data(), c.y.data(), r, kernel_.support(), with_distance(meet));
  }
  template <class Meet>
  static auto with_distance(const Meet& meet) {
    return [&meet](Run j, const Vec<Pack>& d, const Pack& r2) __attribute__((always_inline)) {
      const Pack inverse = inverse_sqrt(r2);
      meet(j, d, r2 * inverse, inverse);
    };
  }

  /// rho_i = sum_j m W, walls included.
  void sum_density(Particles& particles) {
    for_each(sorted_.slots(), particles.threads, [&](Index slot) {
      if (sorted_.is_image(slot)) return;
      // everyone finds itself, but for one without a place, whose volume must stay finite
      const double sum = max(sum_of_kernels(sorted_.columns.position(slot)), kernel_.value(0.0));
      particles.density(sorted_.id(slot)) = fluid_.mass * sum;
    });
    for_each(sorted_.slots(), particles.threads,
             [&](Index slot) { take_density(slot, particles.density(sorted_.id(slot))); });
  }
  [[gnu::flatten]] double sum_of_kernels(const Vector& r) const {
    Pack total(0.0);
    const auto meet = [&](Run, const Vec<Pack>&, const Pack& distance, const Pack&) {
      total += kernel_.value(distance);
    };
    around(r, meet);
    around_walls(r, meet);
    return sum(total);
  }

  /// d rho_i/dt = rho_i sum_j V_j v_ij.grad W, walls at rest included, and the diffusion of density among the
  /// fluid (Molteni & Colagrossi 2009), from which the hydrostatic part is taken out (Fourtakas et al. 2019):
  ///   2 delta h c sum_j V_j [rho_i - rho_j - rho_0 g.d/c^2] W'/r.
  /// Returns the power that the diffusion takes: -m p/rho^2 times its rate.
  [[gnu::flatten]] double continuity(Index slot, Column& rate) const {
    const auto& c = sorted_.columns;
    const auto i = c.at(slot);
    const Vec<Pack> velocity{Pack(i.velocity.x), Pack(i.velocity.y)};
    const double c2 = fluid_.state.sound_speed * fluid_.state.sound_speed;
    const Vec<Pack> at_rest{Pack(fluid_.state.reference_density / c2 * gravity_.x),
                            Pack(fluid_.state.reference_density / c2 * gravity_.y)};
    Pack compression(0.0), diffusion(0.0);
    around(c.position(slot), [&](Run at, const Vec<Pack>& d, const Pack& r, const Pack& inverse) {
      const auto j = c.at(at);
      const Pack weight = j.volume * kernel_.slope_over_r(r, inverse);
      compression += weight * dot(velocity - j.velocity, d);
      diffusion += weight * (i.density - j.density - dot(at_rest, d));
    });
    around_walls(c.position(slot), [&](Run at, const Vec<Pack>& d, const Pack& r, const Pack& inverse) {
      const Pack volume = load(walls_.columns.volume.data(), at);
      compression += volume * kernel_.slope_over_r(r, inverse) * dot(velocity - walls_.own_velocity(at), d);
    });
    const double spread = diffusion_ * sum(diffusion);
    rate(sorted_.id(slot)) = i.density * sum(compression) + spread;
    return -i.volume * i.pressure / i.density * spread;
  }

  /// Pressure and mirrored velocity of the walls' particles, from the fluid beside them.
  void wet_walls(int threads, double t) {
    for_each(walls_.size(), threads, [&](Index slot) { wet_wall(slot, t); });
    walls_.copy_to_images();
  }
  [[gnu::flatten]] void wet_wall(Index slot, double t) {
    constexpr bool velocities = (RubsWalls<Laws> || ...);
    const Vector at_wall = laws_.field(walls_.columns.position(slot), t);
    const Vec<Pack> g{Pack(at_wall.x), Pack(at_wall.y)};
    Pack weights(0.0), pressure(0.0);
    Vec<Pack> velocity{Pack(0.0), Pack(0.0)};
    around(walls_.columns.position(slot), [&](Run at, const Vec<Pack>& d, const Pack& r, const Pack&) {
      const auto j = sorted_.columns.at(at);
      const Pack weight = kernel_.value(r);
      weights += weight;
      pressure += weight * (j.pressure + j.density * dot(g, d));
      if constexpr (velocities) velocity += weight * j.velocity;
    });
    auto& c = walls_.columns;
    const double total = sum(weights), p = total > 0 ? sum(pressure) / total : 0;
    c.pressure(slot) = fluid_.state.tension || !(p < 0) ? p : 0;
    if constexpr (velocities) {
      const Vector own = walls_.own_velocity(slot);
      c.vx(slot) = total > 0 ? 2 * own.x - sum(velocity.x) / total : own.x;
      c.vy(slot) = total > 0 ? 2 * own.y - sum(velocity.y) / total : own.y;
    }
  }

  /// Acceleration of every particle by the laws `Some`; returns the power that they take out of the motion
  /// and the compression of the fluid.
  template <class... Some>
  double accelerate(Particles& particles, double t, Vectors& a) {
    const auto p = view_of<UniformMass>(particles);
    return sum_over(sorted_.slots(), particles.threads, [&](Index slot, std::size_t) {
      if (sorted_.is_image(slot)) return 0.0;
      const Index i = sorted_.id(slot);
      Vector acceleration = laws_.template body<Some...>(p, i, t);
      double power = 0;
      if constexpr ((FluidLaw<Some> || ...)) {
        const auto [force, lost, others] = by_neighbours<Some...>(slot);
        if (others > 0) met_at_one_point_ += others;
        acceleration += 1 / fluid_.mass * force;
        power = lost;
      }
      a(i, 0) = acceleration.x;
      a(i, 1) = acceleration.y;
      particles.pressure(i) = sorted_.columns.pressure(slot);
      return power;
    });
  }

  /// What an implicit law does to the velocities that a step has led to, and the energy it takes out of them.
  /// Accelerations that an integrator keeps for its next step must not depend on velocities: these change.
  template <class L>
  void act_implicitly(System& s, double dt) {
    if constexpr (ActsImplicitly<L>) {
      static_assert(!(takes_energy<Laws> || ...),
                    "Beside an implicit law no explicit one may depend on the velocities of pairs.");
      const PhaseTimer timer(timed, seconds.forces);
      const int threads = s.particles.threads;
      sorted_.build(s.particles, [&](Index slot, Index i) { take_density(slot, s.density(i)); });
      solved_ = solve_implicitly(friction_sweep<L>(dt, threads), s.velocity,
                                 laws_.template get<L>().tolerance, threads);
      s.dissipated_energy += fluid_.mass * solved_.taken;
    }
  }
  template <class L>
  auto friction_sweep(double dt, int threads) {
    return FrictionSweep(laws_.template get<L>(), kernel_, sorted_, walls_, dt / fluid_.mass, threads);
  }
  /// One law by itself, for its cost: of an implicit one, one sweep of the many that a solve takes.
  template <class L>
  void act_alone(Particles& particles, double t, Vectors& result) {
    if constexpr (ActsImplicitly<L>)
      friction_sweep<L>(1, particles.threads).apply(particles.velocity, true, result);
    else
      accelerate<L>(particles, t, result);
  }

  static constexpr double nowhere = 1e-130;  ///< distance that `one_point` becomes [L]

  struct Outcome {
    Vector force;  ///< [kg L/s^2] per unit of depth
    double lost;   ///< power [energy/s]
    int others;    ///< particles at the very same place, which exert no force
  };

  template <class... Some>
  [[gnu::flatten]] Outcome by_neighbours(Index slot) const {
    const auto& c = sorted_.columns;
    const auto i = c.at(slot);
    const Vec<Pack> velocity{Pack(i.velocity.x), Pack(i.velocity.y)};
    Vec<Pack> force{Pack(0.0), Pack(0.0)};
    Pack power(0.0);
    int at_one_point = -1;  // itself
    around(c.position(slot), [&](Run at, const Vec<Pack>& d, const Pack& r, const Pack& inverse) {
      const auto j = c.at(at);
      const Pack weight = j.volume * kernel_.slope_over_r(r, inverse);
      const Vec<Pack> v = velocity - j.velocity;
      const Meeting ij{d, inverse, dot(v, d)};
      at_one_point += popcount(r < nowhere);
      add(force, weight, (stress(laws_.template get<Some>(), i, j, ij) + ...), d);
      add(force, weight, (friction(laws_.template get<Some>(), i, j, ij) + ...), v);
      add(power, weight, (loss(laws_.template get<Some>(), i, j, ij, v) + ...));
    });
    Vector total{sum(force.x), sum(force.y)};
    double lost = -0.5 * sum(power);  // each pair is met twice

    if constexpr ((StressesWalls<Some> || ...) || (RubsWalls<Some> || ...)) {
      Vec<Pack> push{Pack(0.0), Pack(0.0)};
      Pack squeeze(0.0);
      around_walls(c.position(slot), [&](Run at, const Vec<Pack>& d, const Pack& r, const Pack& inverse) {
        const auto j = walls_.columns.at(at);
        const Pack weight = j.volume * kernel_.slope_over_r(r, inverse);
        const Vec<Pack> v = velocity - j.velocity;
        const Meeting ij{d, inverse, dot(v, d)};
        add(push, weight, (wall_stress(laws_.template get<Some>(), i, j, ij) + ...), d);
        add(push, weight, (wall_friction(laws_.template get<Some>(), i, j, ij) + ...), v);
        squeeze += weight * dot(velocity - walls_.own_velocity(at), d) *
                   (form_ == DensityForm::summation ? j.density / i.density : Pack(1.0));
      });
      const Vector by_walls{sum(push.x), sum(push.y)};
      total += by_walls;
      lost -= dot(by_walls, i.velocity) + i.pressure * sum(squeeze);
    }
    return {i.volume * total, i.volume * lost, at_one_point};
  }

  template <class L>
  static constexpr bool takes_energy = requires {
    requires L::dissipates;
  };

  // One law in a sum; None where it has no such hook.
  template <class L>
  static auto stress(const L& law, const auto& i, const auto& j, const Meeting& ij) {
    if constexpr (ActsByStress<L>)
      return Pack(law.stress(i, j, ij));
    else
      return None{};
  }
  template <class L>
  static auto friction(const L& law, const auto& i, const auto& j, const Meeting& ij) {
    if constexpr (ActsByFriction<L>)
      return Pack(law.friction(i, j, ij));
    else
      return None{};
  }
  template <class L>
  static auto wall_stress(const L& law, const auto& i, const auto& j, const Meeting& ij) {
    if constexpr (StressesWalls<L>)
      return Pack(law.wall_stress(i, j, ij));
    else
      return None{};
  }
  template <class L>
  static auto wall_friction(const L& law, const auto& i, const auto& j, const Meeting& ij) {
    if constexpr (RubsWalls<L>)
      return Pack(law.wall_friction(i, j, ij));
    else
      return None{};
  }
  /// What the pair's forces do to its motion, for the laws that take energy out of it.
  template <class L>
  static auto loss(const L& law, const auto& i, const auto& j, const Meeting& ij, const Vec<Pack>& v) {
    if constexpr (!takes_energy<L>)
      return None{};
    else if constexpr (ActsByStress<L>)
      return Pack(law.stress(i, j, ij) * ij.approach);
    else
      return Pack(law.friction(i, j, ij) * dot(v, v));
  }

  static void add(Vec<Pack>& /*sum*/, const Pack& /*weight*/, None /*nothing*/, const Vec<Pack>& /*along*/) {}
  static void add(Vec<Pack>& sum, const Pack& weight, const Pack& strength, const Vec<Pack>& along) {
    sum += (weight * strength) * along;
  }
  static void add(Pack& /*sum*/, const Pack& /*weight*/, None /*nothing*/) {}
  static void add(Pack& sum, const Pack& weight, const Pack& strength) { sum += weight * strength; }

  LawSet<UniformMass, Laws...> laws_;
  DensityForm form_;
  Fluid fluid_;
  Kernel kernel_;
  FluidArrangement sorted_;
  DummyWalls walls_;
  Vector gravity_{0, 0};  ///< [L/s^2]
  double diffusion_ = 0;  ///< 2 delta h c [L^2/s]
  std::atomic<long long> met_at_one_point_ = 0;
  [[no_unique_address]] std::conditional_t<(ActsImplicitly<Laws> || ...), Solved, None> solved_;
};

}  // namespace clapotis
