#include "common/simulation/system.hpp"

#include "common/simulation/model.hpp"

namespace clapotis {

void System::evaluate(double t) {
  model.evaluate(*this, t);
  if (bear) bear(*this);
  ++force_evaluations;
}

void System::evaluate_density_rate() {
  if (advances_density()) model.evaluate_density_rate(*this);
}

void System::drift(double dt) {
  if (!advances_density()) {
    assign(position, position + dt * velocity);
    return;
  }
  assign(position, position + dt / 2 * velocity);
  evaluate_density_rate();
  assign(density, density + dt * density_rate, position, position + dt / 2 * velocity);
  dissipated_energy += dt * diffusion;
}

}  // namespace clapotis
