#pragma once

#include <atomic>

#include "common/laws/hand.hpp"
#include "common/laws/open_ends.hpp"
#include "common/simulation/fluid_hooks.hpp"
#include "common/simulation/fluid_neighbours.hpp"
#include "common/simulation/implicit_step.hpp"
#include "common/simulation/law_set.hpp"
#include "common/simulation/phase_timer.hpp"
#include "common/simulation/state_bytes.hpp"

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
  /// The scene has stated the parameters of `Fluid`. `walls` may be empty; `period` is that of the plane;
  /// open ends need a density that is advanced.
  FluidModel(Parameters& p, DensityForm form, DummyWalls walls = {}, const Period& period = {},
             OpenEnds ends = {})
      : laws_(p),
        form_(form),
        fluid_(Fluid::from(p)),
        near_(fluid_.h, period, std::move(walls)),
        ends_(std::move(ends)) {
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
    s.diffusion = sum_over(near_.fluid.slots(), s.particles.threads, [&](Index slot, std::size_t) {
      return near_.fluid.is_image(slot) ? 0.0 : continuity(slot, s.particles.density_rate);
    });
  }

  void settle(System& s, double dt) override {
    (act_implicitly<Laws>(s, dt), ...);
    laws_.settle(s, dt);
    near_.fluid.period().wrap(s.position);
    if (ends_.exist())
      ends_.renew(s, fluid_.state.sound_speed, [&](Index i) { return energy_of(s.particles, i); });
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
    return {.potential = laws_.potential(particles) + pair_energy(particles),
            .internal = sum_over(
                sums ? near_.fluid.slots() : particles.size(), particles.threads, [&](Index k, std::size_t) {
                  if (sums && near_.fluid.is_image(k)) return 0.0;
                  const double density =
                      sums ? fluid_.mass * near_.sum_of_kernels(near_.fluid.columns.position(k))
                           : particles.density(k);
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
    return near_.walls.size() > 0 ? &near_.walls : nullptr;
  }
  [[nodiscard]] Hand* hand() override {
    if constexpr ((std::is_same_v<Laws, Hand> || ...))
      return &laws_.template get<Hand>();
    else
      return nullptr;
  }
  [[nodiscard]] Vectors obstacles() const override { return obstacles_; }
  void put_obstacles(const Vectors& places) override {
    if (obstacles_.rows() == 0) bare_walls_ = near_.walls.places;
    obstacles_ = places;
    Vectors all(bare_walls_.rows() + places.rows(), 2);
    all << bare_walls_, places;
    near_.walls = DummyWalls(all, fluid_, near_.kernel.support(), near_.fluid.period());
  }
  void pass_state(StateBytes& state) override {
    auto obstacles = obstacles_;
    state(obstacles);
    const bool others = obstacles.rows() != obstacles_.rows() || (obstacles != obstacles_).any();
    if (state.reads() && others) put_obstacles(obstacles);
    if (auto* mine = hand())
      state(mine->touch.at.x, mine->touch.at.y, mine->touch.pull, mine->touch.shake.x, mine->touch.shake.y);
  }
  [[nodiscard]] bool has_open_ends() const override { return ends_.exist(); }
  [[nodiscard]] Column vorticity(const Particles& particles) override {
    arrange(particles);
    Column curl(particles.size());
    for_each(near_.fluid.slots(), particles.threads, [&](Index slot) {
      if (!near_.fluid.is_image(slot)) curl(near_.fluid.id(slot)) = near_.curl_at(slot);
    });
    return curl;
  }
  [[nodiscard]] std::vector<double> law_seconds(const System& s, int repetitions) override {
    Vectors scratch(s.particles.size(), 2);
    Particles& particles = const_cast<System&>(s).particles;
    return {median_seconds_of(repetitions, [&] { act_alone<Laws>(particles, s.time, scratch); })...};
  }
  [[nodiscard]] std::optional<Neighbourhood> neighbourhood(const Particles& particles, Index i) override {
    arrange(particles);
    return near_.fluid.neighbourhood(row(particles.position, i), i);
  }
  [[nodiscard]] std::vector<ActingLaw> accelerations_by_law(const System& s, Index i) override {
    const Index slot = near_.fluid.slot_of(i);
    return laws_.one_by_one([&]<class L>() {
      if (ends_.hold(near_.fluid.columns.position(slot))) return Vector{0, 0};
      Vector a = laws_.template body<L>(view_of<UniformMass>(s.particles), i, s.time);
      if constexpr (FluidLaw<L>) a += 1 / fluid_.mass * by_neighbours<L>(slot).force;
      if constexpr (ActsImplicitly<L>) a += friction_sweep<L>(1, s.particles.threads).change_of(slot);
      return a;
    });
  }
  [[nodiscard]] std::optional<KernelAround> kernel_around(Index i) override { return near_.seen_from(i); }
  [[nodiscard]] PairCount count_pairs(const Particles& particles) override {
    arrange(particles);
    return near_.fluid.count_pairs();
  }
  [[nodiscard]] bool has_pairs() const override { return true; }
  /// Of the law that acts implicitly, in the last step.
  [[nodiscard]] const Solved& solved() const requires(ActsImplicitly<Laws> || ...) { return solved_; }
  [[nodiscard]] std::size_t bytes() const override { return near_.fluid.bytes() + near_.walls.bytes(); }

 private:
  void read(Parameters& p) {
    const auto* g = p.find("gravity");
    gravity_ = {0, g != nullptr ? -g->value : 0};
    if (form_ == DensityForm::continuity)
      diffusion_ =
          2 * fluid_.h * fluid_.state.sound_speed *
          p.number({.name = "delta", .symbol = "delta", .unit = "", .value = 0.1, .range = not_negative});
  }

  /// Of a particle whose density is advanced.
  [[nodiscard]] double energy_of(const Particles& particles, Index i) const {
    const Vector v = row(particles.velocity, i);
    return fluid_.mass * (dot(v, v) / 2 + fluid_.state.energy(particles.density(i))) +
           laws_.potential(particles, i);
  }

  void arrange(const Particles& particles) {
    const PhaseTimer timer(timed, seconds.neighbours);
    if (form_ == DensityForm::continuity)
      near_.fluid.build(particles, [&](Index slot, Index i) { take_density(slot, particles.density(i)); });
    else
      near_.fluid.build(particles, [](Index, Index) {});
  }

  /// V = m/rho, and p by the Cole equation.
  void take_density(Index slot, double density) {
    auto& c = near_.fluid.columns;
    c.density(slot) = FluidArrangement::finite_or(density, fluid_.state.reference_density);
    c.volume(slot) = fluid_.mass / c.density(slot);
    c.pressure(slot) = fluid_.state.pressure(c.density(slot));
  }

  /// rho_i = sum_j m W, walls included.
  void sum_density(Particles& particles) {
    for_each(near_.fluid.slots(), particles.threads, [&](Index slot) {
      if (near_.fluid.is_image(slot)) return;
      // everyone finds itself, but for one without a place, whose volume must stay finite
      const double sum =
          max(near_.sum_of_kernels(near_.fluid.columns.position(slot)), near_.kernel.value(0.0));
      particles.density(near_.fluid.id(slot)) = fluid_.mass * sum;
    });
    for_each(near_.fluid.slots(), particles.threads,
             [&](Index slot) { take_density(slot, particles.density(near_.fluid.id(slot))); });
  }
  /// d rho_i/dt = rho_i sum_j V_j v_ij.grad W, walls at rest included, and the diffusion of density among the
  /// fluid (Molteni & Colagrossi 2009), from which the hydrostatic part is taken out (Fourtakas et al. 2019):
  ///   2 delta h c sum_j V_j [rho_i - rho_j - rho_0 g.d/c^2] W'/r.
  /// Returns the power that the diffusion takes: -m p/rho^2 times its rate; where open ends hold the density,
  /// the power that would have compressed it.
  [[gnu::flatten]] double continuity(Index slot, Column& rate) const {
    const auto& c = near_.fluid.columns;
    const auto i = c.at(slot);
    const Vec<Pack> velocity{Pack(i.velocity.x), Pack(i.velocity.y)};
    const double c2 = fluid_.state.sound_speed * fluid_.state.sound_speed;
    const Vec<Pack> at_rest{Pack(fluid_.state.reference_density / c2 * gravity_.x),
                            Pack(fluid_.state.reference_density / c2 * gravity_.y)};
    Pack compression(0.0), diffusion(0.0);
    near_.around(c.position(slot), [&](Run at, const Vec<Pack>& d, const Pack& r, const Pack& inverse) {
      const auto j = c.at(at);
      const Pack weight = j.volume * near_.kernel.slope_over_r(r, inverse);
      compression += weight * dot(velocity - j.velocity, d);
      diffusion += weight * (i.density - j.density - dot(at_rest, d));
    });
    near_.around_walls(c.position(slot), [&](Run at, const Vec<Pack>& d, const Pack& r, const Pack& inverse) {
      const Pack volume = load(near_.walls.columns.volume.data(), at);
      compression +=
          volume * near_.kernel.slope_over_r(r, inverse) * dot(velocity - near_.walls.own_velocity(at), d);
    });
    const double spread = diffusion_ * sum(diffusion), squeezed = i.density * sum(compression);
    const bool held = ends_.hold(c.position(slot));
    rate(near_.fluid.id(slot)) = held ? 0 : squeezed + spread;
    return i.volume * i.pressure / i.density * (held ? squeezed : -spread);
  }

  /// What the laws store between the particles of the fluid, each with itself included.
  double pair_energy(const Particles& particles) {
    if constexpr (!(StoresBetweenParticles<Laws> || ...)) {
      return 0;
    } else {
      arrange(particles);
      return sum_over(near_.fluid.slots(), particles.threads, [&](Index slot, std::size_t) {
        if (near_.fluid.is_image(slot)) return 0.0;
        Pack total(0.0);
        near_.around(near_.fluid.columns.position(slot),
                     [&](Run, const Vec<Pack>&, const Pack& r, const Pack&) {
                       laws_.each([&](const auto& law) {
                         if constexpr (requires { law.pair_energy(r); }) total += law.pair_energy(r);
                       });
                     });
        return sum(total) / 2;  // each pair is met twice
      });
    }
  }

  /// Pressure and mirrored velocity of the walls' particles, from the fluid beside them.
  void wet_walls(int threads, double t) {
    for_each(near_.walls.size(), threads, [&](Index slot) { wet_wall(slot, t); });
    near_.walls.copy_to_images();
  }
  [[gnu::flatten]] void wet_wall(Index slot, double t) {
    constexpr bool velocities = (RubsWalls<Laws> || ...);
    const Vector at_wall = laws_.field(near_.walls.columns.position(slot), t);
    const Vec<Pack> g{Pack(at_wall.x), Pack(at_wall.y)};
    Pack weights(0.0), pressure(0.0);
    Vec<Pack> velocity{Pack(0.0), Pack(0.0)};
    near_.around(near_.walls.columns.position(slot),
                 [&](Run at, const Vec<Pack>& d, const Pack& r, const Pack&) {
                   const auto j = near_.fluid.columns.at(at);
                   const Pack weight = near_.kernel.value(r);
                   weights += weight;
                   pressure += weight * (j.pressure + j.density * dot(g, d));
                   if constexpr (velocities) velocity += weight * j.velocity;
                 });
    auto& c = near_.walls.columns;
    const double total = sum(weights), p = total > 0 ? sum(pressure) / total : 0;
    c.pressure(slot) = fluid_.state.tension || !(p < 0) ? p : 0;
    if constexpr (velocities) {
      const Vector own = near_.walls.own_velocity(slot);
      c.vx(slot) = total > 0 ? 2 * own.x - sum(velocity.x) / total : own.x;
      c.vy(slot) = total > 0 ? 2 * own.y - sum(velocity.y) / total : own.y;
    }
  }

  /// Acceleration of every particle by the laws `Some`; returns the power that they take out of the motion
  /// and the compression of the fluid.
  template <class... Some>
  double accelerate(Particles& particles, double t, Vectors& a) {
    const auto p = view_of<UniformMass>(particles);
    return sum_over(near_.fluid.slots(), particles.threads, [&](Index slot, std::size_t) {
      if (near_.fluid.is_image(slot)) return 0.0;
      const Index i = near_.fluid.id(slot);
      Vector acceleration = laws_.template body<Some...>(p, i, t);
      double power = 0;
      if constexpr ((FluidLaw<Some> || ...)) {
        const auto [force, lost, others] = by_neighbours<Some...>(slot);
        if (others > 0) met_at_one_point_ += others;
        acceleration += 1 / fluid_.mass * force;
        power = lost;
      }
      if (ends_.hold(near_.fluid.columns.position(slot))) {
        power += fluid_.mass * dot(acceleration, row(particles.velocity, i));
        acceleration = {0, 0};
      }
      a(i, 0) = acceleration.x;
      a(i, 1) = acceleration.y;
      particles.pressure(i) = near_.fluid.columns.pressure(slot);
      return power;
    });
  }

  /// What an implicit law does to the velocities that a step has led to, and the energy it takes out of them.
  /// Accelerations that an integrator keeps for its next step must not depend on velocities: these change.
  template <class L>
  void act_implicitly(System& s, double dt) {
    if constexpr (ActsImplicitly<L>) {
      static_assert(!(hooks::takes_energy<Laws> || ...),
                    "Beside an implicit law no explicit one may depend on the velocities of pairs.");
      const PhaseTimer timer(timed, seconds.forces);
      const int threads = s.particles.threads;
      near_.fluid.build(s.particles, [&](Index slot, Index i) { take_density(slot, s.density(i)); });
      solved_ = solve_implicitly(friction_sweep<L>(dt, threads), s.velocity,
                                 laws_.template get<L>().tolerance, threads);
      s.dissipated_energy += fluid_.mass * solved_.taken;
    }
  }
  template <class L>
  auto friction_sweep(double dt, int threads) {
    return FrictionSweep(laws_.template get<L>(), near_.kernel, near_.fluid, near_.walls, dt / fluid_.mass,
                         threads);
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
    const auto& c = near_.fluid.columns;
    const auto i = c.at(slot);
    const Vec<Pack> velocity{Pack(i.velocity.x), Pack(i.velocity.y)};
    Vec<Pack> force{Pack(0.0), Pack(0.0)};
    Pack power(0.0);
    int at_one_point = -1;  // itself
    near_.around(c.position(slot), [&](Run at, const Vec<Pack>& d, const Pack& r, const Pack& inverse) {
      const auto j = c.at(at);
      const Pack weight = j.volume * near_.kernel.slope_over_r(r, inverse);
      const Vec<Pack> v = velocity - j.velocity;
      const Meeting ij{d, inverse, dot(v, d)};
      at_one_point += popcount(r < nowhere);
      hooks::add(force, weight, (hooks::stress(laws_.template get<Some>(), i, j, ij) + ...), d);
      hooks::add(force, weight, (hooks::friction(laws_.template get<Some>(), i, j, ij) + ...), v);
      hooks::add(power, weight, (hooks::loss(laws_.template get<Some>(), i, j, ij, v) + ...));
    });
    Vector total{sum(force.x), sum(force.y)};
    double lost = -0.5 * sum(power);  // each pair is met twice
    if constexpr ((StressesWalls<Some> || ...) || (RubsWalls<Some> || ...)) {
      Vec<Pack> push{Pack(0.0), Pack(0.0)};
      Pack squeeze(0.0);
      near_.around_walls(
          c.position(slot), [&](Run at, const Vec<Pack>& d, const Pack& r, const Pack& inverse) {
            const auto j = near_.walls.columns.at(at);
            const Pack weight = j.volume * near_.kernel.slope_over_r(r, inverse);
            const Vec<Pack> v = velocity - j.velocity;
            const Meeting ij{d, inverse, dot(v, d)};
            hooks::add(push, weight, (hooks::wall_stress(laws_.template get<Some>(), i, j, ij) + ...), d);
            hooks::add(push, weight, (hooks::wall_friction(laws_.template get<Some>(), i, j, ij) + ...), v);
            squeeze += weight * dot(velocity - near_.walls.own_velocity(at), d) *
                       (form_ == DensityForm::summation ? j.density / i.density : Pack(1.0));
          });
      const Vector by_walls{sum(push.x), sum(push.y)};
      total += by_walls;
      lost -= dot(by_walls, i.velocity) + i.pressure * sum(squeeze);
    }
    return {i.volume * total, i.volume * lost, at_one_point};
  }

  LawSet<UniformMass, Laws...> laws_;
  DensityForm form_;
  Fluid fluid_;
  FluidNeighbours<Kernel> near_;
  OpenEnds ends_;
  Vectors bare_walls_{0, 2}, obstacles_{0, 2};  ///< what the walls are made of, where obstacles were drawn
  Vector gravity_{0, 0};                        ///< [L/s^2]
  double diffusion_ = 0;                        ///< 2 delta h c [L^2/s]
  std::atomic<long long> met_at_one_point_ = 0;
  [[no_unique_address]] std::conditional_t<(ActsImplicitly<Laws> || ...), Solved, hooks::None> solved_;
};

}  // namespace clapotis
