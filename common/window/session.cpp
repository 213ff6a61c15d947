#include "common/window/session.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "common/runner/saved_state.hpp"
#include "common/runner/stopwatch.hpp"

namespace clapotis {
namespace {

constexpr int slowest = -10, fastest = 6;  // octaves: 1/1024 to 64 times real time

std::unique_ptr<Parameters> defaults_of(const Scene& scene) {
  return std::make_unique<Parameters>(Simulation(scene).parameters());
}

}  // namespace

Session::Session(const Stage& stage, const Options& options)
    : stage_(stage), threads_(options.threads.value) {
  begin(options);
}

void Session::begin(const Options& options) {
  play(start_simulation(stage_, options));
  given_ = options.parameters;
  paused_ = options.paused;
  until_.reset();
  steps_until_.reset();
  if (options.until && options.until->origin != Origin::law) until_ = options.until->value;
  if (options.steps) steps_until_ = options.steps->value;
}

void Session::start(std::size_t scene, const Overrides& overrides, const std::string& integrator) {
  play(std::make_unique<Simulation>(stage_.scenes[scene], overrides, integrator, threads_));
}

/// Changes nothing before everything that can throw is done.
void Session::play(std::unique_ptr<Simulation> simulation) {
  const Scene& known = stage_.scene(simulation->scene().name);
  const auto scene = static_cast<std::size_t>(&known - stage_.scenes.data());
  if (!defaults_ || scene != scene_) defaults_ = defaults_of(known);
  simulation_ = std::move(simulation);
  scene_ = scene;
  history_.clear();
  history_.add(*simulation_);
  pacer_.forgive();
  diverged_.reset();
  work_ = {};
  preset_.clear();
  ++starts_;
}

void Session::reset() {
  const auto preset = preset_;
  start(scene_, simulation_->parameters().overrides(), simulation_->integrator());
  preset_ = preset;
}

void Session::choose_scene(std::size_t scene) {
  if (scene >= stage_.scenes.size()) return;
  const auto table = defaults_of(stage_.scenes[scene]);
  Overrides known;
  for (const auto& [name, value] : given_) {
    const auto* parameter = table->find(name);
    if (parameter != nullptr && (value.unit.empty() || value.unit == parameter->unit))
      known.emplace(name, value);
  }
  start(scene, known, simulation_->integrator());
}

void Session::choose_integrator(const std::string& name) {
  if (diverged_) {
    start(scene_, simulation_->parameters().overrides(), name);
  } else {
    simulation_->use_integrator(name);
  }
}

void Session::set(const std::string& parameter, const std::string& value) {
  const Parameter* known = simulation_->parameters().find(parameter);
  if (known == nullptr || known->change == Change::live) {
    simulation_->set(parameter, value);
    return;
  }
  Parameters changed = simulation_->parameters();
  changed.set(parameter, value, Origin::window);
  start(scene_, changed.overrides(), simulation_->integrator());
}

void Session::restore(const SavedState& saved) { play(resume_simulation(stage_, saved, threads_)); }

void Session::choose_preset(const std::string& name) {
  start(scene_, simulation_->scene().preset(name, Origin::window), simulation_->integrator());
  preset_ = name;
}

void Session::restore_defaults() { start(scene_, {}, simulation_->integrator()); }

void Session::change_speed(int octaves) { octaves_ = std::clamp(octaves_ + octaves, slowest, fastest); }

double Session::speed() const { return std::ldexp(1.0, octaves_); }

/// False when the run stopped.
bool Session::step_once() {
  const double before = simulation_->time();
  try {
    const bool before_end = until_ && simulation_->time() < *until_;
    simulation_->step(before_end ? *until_ : std::numeric_limits<double>::infinity());
  } catch (const Diverged& reason) {
    diverged_ = reason;
    return false;
  }
  ++work_.steps;
  work_.simulated += simulation_->time() - before;
  if (after_step_) after_step_(*simulation_);
  return true;
}

/// True at the one step that gets there: whoever goes on from there is not stopped again.
bool Session::reached_end() const {
  return (until_ && simulation_->time() == *until_) ||
         (steps_until_ && simulation_->steps() == *steps_until_);
}

void Session::step(int count) {
  if (diverged_) return;
  paused_ = true;
  work_ = {};
  const double start = wall_seconds();
  for (int k = 0; k < count && !diverged_ && step_once(); ++k) {
  }
  work_.seconds = wall_seconds() - start;
  if (work_.steps > 0) history_.add(*simulation_);
}

void Session::advance(double elapsed, double budget) {
  work_ = {};
  if (paused_ || diverged_) return;
  pacer_.pass(elapsed, speed());
  const double start = wall_seconds();
  while (pacer_.due(simulation_->dt())) {
    if (work_.steps > 0 && wall_seconds() - start > budget) {
      work_.within_budget = false;
      pacer_.forgive();
      break;
    }
    const double before = work_.simulated;
    if (!step_once()) break;
    pacer_.pay(work_.simulated - before);
    if (reached_end()) {
      paused_ = true;
      break;
    }
  }
  work_.seconds = wall_seconds() - start;
  if (work_.steps > 0) history_.add(*simulation_);
}

}  // namespace clapotis
