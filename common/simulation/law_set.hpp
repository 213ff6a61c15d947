#pragma once

#include <optional>
#include <string>
#include <tuple>
#include <vector>

#include "common/laws/law.hpp"
#include "common/particles/parallel.hpp"
#include "common/simulation/model.hpp"
#include "common/simulation/system.hpp"

namespace clapotis {

/// The laws of a scene, and what follows from all of them together. A hook that a law lacks generates no
/// code.
template <class Mass, Law... Laws>
class LawSet {
 public:
  explicit LawSet(Parameters& parameters) : laws_{Laws::from(parameters)...} {}
  void refresh(Parameters& parameters) { laws_ = {again(get<Laws>(), parameters)...}; }

  template <class L>
  [[nodiscard]] const L& get() const {
    return std::get<L>(laws_);
  }
  template <class L>
  [[nodiscard]] L& get() {
    return std::get<L>(laws_);
  }
  template <class Act>
  void each(const Act& act) const {
    std::apply([&](const auto&... law) { (act(law), ...); }, laws_);
  }
  template <class Term>
  double sum(const Term& term) const {
    return std::apply([&](const auto&... law) { return (term(law) + ... + 0.0); }, laws_);
  }

  /// Acceleration of particle i by the laws `Some` that act on one particle.
  template <class... Some>
  [[nodiscard]] Vector body(const auto& p, Index i, double t) const {
    Vector total{0, 0};
    const auto add = [&](const auto& law) {
      if constexpr (requires { law.body(p, i, t); }) total += law.body(p, i, t);
      if constexpr (requires { law.field(p.position(i), t); }) total += law.field(p.position(i), t);
    };
    (add(get<Some>()), ...);
    return total;
  }
  /// Acceleration of whatever is at r by the laws that are fields.
  [[nodiscard]] Vector field(const Vector& r, double t) const {
    Vector total{0, 0};
    each([&](const auto& law) {
      if constexpr (requires { law.field(r, t); }) total += law.field(r, t);
    });
    return total;
  }
  /// Power that the laws on one particle take out of the motion of all.
  [[nodiscard]] double dissipation(const Particles& particles, double t) const {
    if constexpr (!(Dissipates<Laws> || ...)) {
      return 0;
    } else {
      const auto p = view_of<Mass>(particles);
      return sum_over(particles.size(), threads_for_little(particles.size(), particles.threads),
                      [&](Index i, std::size_t) {
                        return sum([&](const auto& law) {
                          if constexpr (requires { law.dissipation(p, i, t); })
                            return law.dissipation(p, i, t);
                          else
                            return 0.0;
                        });
                      });
    }
  }
  [[nodiscard]] double potential(const Particles& particles) const {
    return sum_over(particles.size(), threads_for_little(particles.size(), particles.threads),
                    [&](Index i, std::size_t) { return potential(particles, i); });
  }
  /// Of particle i alone.
  [[nodiscard]] double potential(const Particles& particles, Index i) const {
    const auto p = view_of<Mass>(particles);
    return sum([&](const auto& law) {
      if constexpr (requires { law.potential(p, i); })
        return law.potential(p, i);
      else
        return 0.0;
    });
  }
  void settle(System& s, double dt) {
    const auto settle_one = [&](auto& law) {
      if constexpr (requires { law.settle(s, dt); }) law.settle(s, dt);
    };
    std::apply([&](auto&... law) { (settle_one(law), ...); }, laws_);
  }
  [[nodiscard]] std::vector<StepLimit> limits(const Particles& particles) const {
    std::vector<StepLimit> all;
    each([&](const auto& law) {
      if constexpr (requires { law.limit(particles); }) all.push_back(law.limit(particles));
    });
    return all;
  }
  /// What each law that acts on particles gives one of them: `acceleration.template operator()<L>()`.
  [[nodiscard]] static std::vector<ActingLaw> one_by_one(const auto& acceleration) {
    std::vector<ActingLaw> all;
    const auto add = [&]<class L>(std::type_identity<L>) {
      if constexpr (ActsOnParticles<L>)
        all.push_back({.name = L::name, .acceleration = acceleration.template operator()<L>()});
    };
    (add(std::type_identity<Laws>{}), ...);
    return all;
  }
  [[nodiscard]] static std::vector<std::string> names() { return {std::string(Laws::name)...}; }
  [[nodiscard]] std::optional<Walls> walls() const {
    std::optional<Walls> found;
    each([&](const auto& law) {
      if constexpr (requires { law.walls; }) found = law.walls;
    });
    return found;
  }

 private:
  /// The law with its parameters read again; one that holds more than these says how.
  template <class L>
  static L again(const L& law, Parameters& parameters) {
    if constexpr (requires { law.with(parameters); })
      return law.with(parameters);
    else
      return L::from(parameters);
  }

  std::tuple<Laws...> laws_;
};

}  // namespace clapotis
