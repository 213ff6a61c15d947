#pragma once

#include <array>
#include <functional>
#include <memory>

#include "common/integrators/integrator.hpp"
#include "common/laws/walls.hpp"

namespace clapotis {

/// One particle between walls whose impacts are found inside the step, so that they keep the order of the
/// scheme.
///
/// A step that ends beyond a wall is taken back; the share of it that ends on the wall is found on the
/// scheme's own path, the normal velocity is turned round, and the rest of the step follows. Infinitely many
/// impacts end in finite time (Zeno): when all that would follow, lasting 2 e v/(a (1 - e)) together, fit in
/// what is left of the step, the particle stands still. One that stands still on a wall rests there as long
/// as the laws press it on. After `most_impacts` in one step the others are counted in closed form, under the
/// acceleration of that instant: as hops on the wall it is pressed on, else as a flight folded by the walls.
class LocatedImpacts final : public Integrator {
 public:
  static constexpr int most_impacts = 64;

  /// Takes the walls from the system's model, which must have them, and one particle.
  LocatedImpacts(std::unique_ptr<Integrator> scheme, System& system);
  ~LocatedImpacts() override;

  void step(System& system, double dt) override;
  [[nodiscard]] bool leaves_acceleration() const override {
    return !touched_ && scheme_->leaves_acceleration();
  }
  [[nodiscard]] bool controls_error() const override { return scheme_->controls_error(); }
  void read(Parameters& p) override { scheme_->read(p); }

 private:
  struct State {
    Vector r, v;
    double dissipated;
  };
  struct Side {
    int axis;
    bool high;
  };
  /// A piece of a step: from a state at time t, with the acceleration and dissipation there, for dt.
  struct Piece {
    State from;
    Vector a;
    double dissipation;
    double t, dt;
  };
  /// Per axis: -1 at rest on the low wall, +1 on the high one, 0 free.
  using Contact = std::array<int, 2>;

  Piece begin(double t, double dt);
  State run(const Piece& piece, double dt);
  void put(const State& state);
  [[nodiscard]] State state() const;
  [[nodiscard]] double gap(const State& state,
                           const Side& side) const;  ///< from the wall [L]; negative beyond it
  [[nodiscard]] static double closing(const State& state, const Side& side);
  /// When the particle reaches that wall during the piece, which ends in `end`; infinity if it does not.
  double impact_time(const Piece& piece, const State& end, const Side& side);
  double root(const Piece& piece, double from, double to, const std::function<double(const State&)>& value);
  void count_remaining(const Piece& piece);
  void reflect(const Side& side, double rest_of_step);
  void rest_or_release();
  void bear() const;
  void finish(double start);

  std::unique_ptr<Integrator> scheme_;
  System& s_;
  Walls walls_{};
  Contact contact_{0, 0};  ///< during a step
  double ran_ = 0;         ///< how far the last trial of the piece went [s]
  bool touched_ = false;
};

}  // namespace clapotis
