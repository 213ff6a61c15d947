#include "common/integrators/bogacki_shampine.hpp"
#include "common/simulation/simulation.hpp"
#include "common/simulation/time_step.hpp"

namespace clapotis {
namespace {

/// Columns that the laws added, by name, then the values of all.
void pass_particles(StateBytes& state, Particles& particles) {
  std::vector<std::string> names;
  for (const auto& column : particles.extra) names.push_back(column.name);
  const auto own = names;
  state(particles.uniform_mass, names);
  if (names != own) throw ForeignState("the particles have other columns");
  particles.pass_state(state);
}

}  // namespace

/// What changed while the scene ran: the last value of each, and a reference that was for other values is
/// not one any more.
void Simulation::note_change(std::string_view name, std::string_view value, Origin origin) {
  if (name != step_parameter.name && name != cfl_parameter.name && name != tolerance_parameter.name)
    setup_.reference.reset();
  std::erase_if(changes_, [&](const LiveChange& change) { return change.name == name; });
  changes_.push_back({std::string(name), std::string(value), origin});
}

void Simulation::pass_changes(StateBytes& state) {
  const auto changes = changes_;
  auto count = changes.size();
  state(count);
  const bool changed = !changes.empty() || count > 0;
  if (state.reads() && changed) {  // from the parameters as they were before any of them
    if (unchanged_)
      parameters_ = *unchanged_;
    else
      unchanged_ = parameters_;
    changes_.clear();
  }
  for (std::size_t k = 0; k < count; ++k) {
    auto change = state.reads() ? LiveChange{} : changes[k];
    state(change.name, change.value, change.origin);
    if (!state.reads()) continue;
    parameters_.set(change.name, change.value, change.origin);
    note_change(change.name, change.value, change.origin);
  }
  if (!state.reads() || !changed) return;
  setup_.model->refresh(parameters_);
  integrator_->read(parameters_);
}

void Simulation::pass_state(StateBytes& state) {
  auto& s = *system_;
  auto& model = *setup_.model;
  pass_changes(state);
  pass_particles(state, s.particles);
  state(s.time, s.dissipated_energy, s.dissipation, s.diffusion, s.force_evaluations, s.entered, s.left,
        s.current);
  double dt = dt_;
  state(steps_, clock_.start, clock_.dt, clock_.steps, dt, fastest_);
  state(model.coincident, model.folded);
  model.pass_state(state);
  bool referred = setup_.reference.has_value();  // it is none after an edit by hand
  state(referred);
  state.end();
  if (!state.reads()) return;
  setup_.reference = referred ? reference_ : std::nullopt;
  choose_step();  // the limits
  dt_ = dt;
  keep();
}

}  // namespace clapotis
