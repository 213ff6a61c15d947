#pragma once

#include <fmt/core.h>

#include <algorithm>
#include <cmath>

#include "common/laws/law.hpp"
#include "common/simulation/time_step.hpp"

namespace clapotis {

/// Sound travels at most CFL smoothing lengths in a step: dt <= CFL h/(c + |v|), |v| the greatest of all
/// speeds. Verlet and symplectic Euler are stable up to 1.55 of it (tests/stage4/stability_limits_test.cpp
/// measures 1.57 with diffusion of density, 1.7 and more without); explicit Euler and Runge-Kutta 2 have
/// limits of their own, which sink as the run gets longer.
///
/// Verlet predicts the velocity that artificial viscosity damps, and bears less of it: with x = dt c/h its
/// fastest wave stays bounded for (x/1.79)^2 = (1 - 0.147 x) (1 - 0.634 alpha x), the two factors what
/// diffusion and viscosity damp in a step. This is 1.55 at alpha = 0.02, and the measured 1.00 at alpha = 1;
/// beyond, damping alone decides: still water bears 0.86/alpha and not 0.97/alpha.
struct AcousticStep {
  static constexpr std::string_view name = "acoustic_step";
  static constexpr bool follows_state = true;
  static constexpr double stable = 1.55;  ///< of h/(c + |v|), where little is damped
  double h, sound_speed, cfl;
  double bound;  ///< of h/(c + |v|), with the scene's artificial viscosity

  static AcousticStep from(Parameters& p) {
    const auto fluid = Fluid::from(p);
    const auto* alpha = p.find("alpha");
    return {fluid.h, fluid.state.sound_speed, p.number(cfl_parameter),
            alpha != nullptr ? bound_with(alpha->value) : stable};
  }
  static double bound_with(double alpha) {
    constexpr double wave = 1 / (1.79 * 1.79), diffusion = 0.147;
    const double viscosity = 0.634 * alpha, damping = diffusion + viscosity;
    const double square = wave - diffusion * viscosity;  // square x^2 + damping x = 1
    return std::min({stable, 2 / (damping + std::sqrt(damping * damping + 4 * square)), 1 / alpha});
  }
  [[nodiscard]] StepLimit limit(const Particles& particles) const {
    return {.name = "acoustic",
            .formula = fmt::format("{:.3g} h/(c + |v|)", bound),
            .limit = bound * h / (sound_speed + greatest_norm(particles.velocity, particles.threads)),
            .share = cfl / stable};
  }
};
static_assert(Law<AcousticStep> && LimitsStep<AcousticStep> && FollowsState<AcousticStep>);

/// What the greatest force does in a step is small against h: dt <= 0.25 sqrt(h/|a|). Monaghan 1992.
struct ForceStep {
  static constexpr std::string_view name = "force_step";
  static constexpr bool follows_state = true;
  double h;

  static ForceStep from(Parameters& p) { return {Fluid::from(p).h}; }
  [[nodiscard]] StepLimit limit(const Particles& particles) const {
    return {.name = "force",
            .formula = "sqrt(h/|a|)",
            .limit = std::sqrt(h / greatest_norm(particles.acceleration, particles.threads)),
            .share = 0.25,
            .stability = false};
  }
};
static_assert(Law<ForceStep> && LimitsStep<ForceStep> && FollowsState<ForceStep>);

/// The step of the handout, tau = CFL h/c. Handout, section III. Its column of water, run for 20 s with
/// Verlet from eight seeds, never diverges with CFL = 1.2 and once with 1.3.
struct HandoutStep {
  static constexpr std::string_view name = "handout_step";
  double h, sound_speed, cfl;

  static HandoutStep from(Parameters& p) {
    const auto fluid = Fluid::from(p);
    return {fluid.h, fluid.state.sound_speed, p.number(cfl_parameter)};
  }
  [[nodiscard]] StepLimit limit(const Particles& /*particles*/) const {
    constexpr double stable = 1.25;
    return {
        .name = "acoustic", .formula = "1.25 h/c", .limit = stable * h / sound_speed, .share = cfl / stable};
  }
};
static_assert(Law<HandoutStep> && LimitsStep<HandoutStep>);

}  // namespace clapotis
