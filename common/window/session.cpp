#include "common/window/session.hpp"

#include <fmt/core.h>

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
    : stage_(stage), given_(options.parameters), threads_(options.threads.value), paused_(options.paused) {
  if (options.until && options.until->origin != Origin::law) until_ = options.until->value;
  if (options.steps) steps_until_ = options.steps->value;
  play(start_simulation(stage, options));
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
  past_.begin(shown());
  pacer_.forgive();
  diverged_.reset();
  work_ = {};
  preset_.clear();
  ++starts_;
  ++leaps_;
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

double Session::half_step() const { return std::stod(fmt::format("{:.2g}", simulation_->dt() / 2)); }

void Session::halve_step() {
  Parameters changed = simulation_->parameters();
  changed.set("dt", to_text(half_step()), Origin::window);
  start(scene_, changed.overrides(), simulation_->integrator());
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
  const long known = past_.changed(shown()) ? 0 : past_.newest().step - simulation_->steps();
  const auto again = std::clamp<long>(known, 0, count);
  if (again > 0) return_to(simulation_->steps() + again);
  work_ = {};
  if (again == count) return;
  leave_known_time();
  const double start = wall_seconds();
  for (long k = again; k < count && !diverged_ && step_once(); ++k) {
  }
  note_work(start);
}

/// Before a new step: what lies ahead is not what comes, and what somebody did since the last step is not to
/// be lost.
void Session::leave_known_time() {
  const bool known = past_.newest().step > simulation_->steps();
  if (known) history_.cut();
  if (known || past_.changed(shown())) past_.keep(shown());
}

void Session::note_work(double start) {
  work_.seconds = wall_seconds() - start;
  if (work_.steps == 0) return;
  history_.add(*simulation_);
  past_.pass(shown(), work_.seconds);
}

/// Before a leap: the end of what is known is to be found again.
void Session::keep_end() {
  if (past_.changed(shown()) || simulation_->steps() > past_.newest().step) {
    leave_known_time();
    past_.keep(shown());
  }
}

void Session::step_back(int count) {
  keep_end();
  return_to(std::max(simulation_->steps() - count, past_.oldest().step));
}

void Session::go_to(double time) {
  keep_end();
  paused_ = true;
  const auto& now = *simulation_;
  const auto moment = past_.before(time);
  const bool on_the_way = now.steps() >= moment.step && now.time() <= std::max(time, moment.time);
  if (!on_the_way) return_to(moment.step);
  const long last = now.steps();
  while (now.steps() < past_.newest().step && now.time() + now.dt() <= time &&
         past_.before(now.steps() + 1).step == moment.step)
    step_once();
  if (now.steps() > last) return_to(now.steps());
}

/// Forwards or back, in known time. From a moment that is kept on, the same steps come to the same bits.
void Session::return_to(long step) {
  const long kept = past_.before(step).step, now = simulation_->steps();
  if (now > step || now < kept) past_.restore(shown(), step);
  diverged_.reset();
  paused_ = true;
  ++leaps_;
  pacer_.forgive();
  while (simulation_->steps() < step && step_once()) {
  }
  work_ = {};
  history_.show(*simulation_);
}

void Session::advance(double elapsed, double budget) {
  work_ = {};
  if (paused_ || diverged_) return;
  pacer_.pass(elapsed, speed());
  if (pacer_.due(simulation_->dt())) leave_known_time();
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
  note_work(start);
}

}  // namespace clapotis
