#include "common/window/session.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "common/runner/saved_state.hpp"
#include "common/runner/stopwatch.hpp"
#include "common/words.hpp"

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
  auto simulation = start_simulation(stage_, options);
  sides_.reset();
  play(std::move(simulation));
  given_ = options.parameters;
  paused_ = options.paused;
  until_.reset();
  steps_until_.reset();
  if (options.until && options.until->origin != Origin::law) until_ = options.until->value;
  if (options.steps) steps_until_ = options.steps->value;
  if (options.beside) put_beside(options.beside->first, options.beside->second);
}

void Session::start(std::size_t scene, const Overrides& overrides, const std::string& integrator) {
  play(std::make_shared<Simulation>(stage_.scenes[scene], overrides, integrator, threads_));
}

/// Changes nothing before everything that can throw is done.
void Session::play(std::shared_ptr<Simulation> simulation) {
  auto sides = sides_ ? std::make_unique<SideBySide>(stage_, simulation, contrast_for(*simulation)) : nullptr;
  const Scene& known = stage_.scene(simulation->scene().name);
  const auto scene = static_cast<std::size_t>(&known - stage_.scenes.data());
  if (!defaults_ || scene != scene_) {
    defaults_ = defaults_of(known);
    contrast_.reset();
  }
  simulation_ = std::move(simulation);
  sides_ = std::move(sides);
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
    if (sides_) sides_->level();
    simulation_->use_integrator(name);
    if (!sides_) return;
    if (sides_->contrast().name != "integrator") sides_->right().simulation->use_integrator(name);
    sides_->changed();
  }
}

void Session::set(const std::string& parameter, const std::string& value) {
  const Parameter* known = simulation_->parameters().find(parameter);
  if (known == nullptr || known->change == Change::live) {
    if (sides_) return set_both(parameter, value);
    simulation_->set(parameter, value);
    return;
  }
  Parameters changed = simulation_->parameters();
  changed.set(parameter, value, Origin::window);
  start(scene_, changed.overrides(), simulation_->integrator());
}

/// A saved state is that of one side: what would the other be?
void Session::restore(const SavedState& saved) {
  auto simulation = resume_simulation(stage_, saved, threads_);
  sides_.reset();
  play(std::move(simulation));
}

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
  if (stopped()) return;
  paused_ = true;
  work_ = {};
  if (sides_)
    return act_on_sides([&] {
      for (int k = 0; k < count; ++k) sides_->step();
      return true;
    });
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
  if (sides_) throw BadInput(std::string(words().window.past.two_sides));
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
  if (paused_ || stopped()) return;
  if (sides_)
    return act_on_sides(
        [&] { return sides_->advance(std::clamp(elapsed, 0.0, Pacer::longest_frame) * speed(), budget); });
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

// Two sides.

/// What was chosen in this scene, or else the scene's own.
Contrast Session::contrast_for(const Simulation& left) const {
  const auto known = contrasts(left);
  const bool holds = contrast_ && left.scene().name == simulation_->scene().name &&
                     std::find(known.begin(), known.end(), contrast_->name) != known.end();
  return holds ? *contrast_ : first_contrast(left);
}

/// Changes nothing before everything that can throw is done.
void Session::start_sides(const Contrast& contrast) {
  auto left = std::make_shared<Simulation>(stage_.scenes[scene_], simulation_->parameters().overrides(),
                                           simulation_->integrator(), threads_);
  auto sides = std::make_unique<SideBySide>(stage_, left, contrast);
  const auto preset = preset_;
  sides_.reset();
  play(std::move(left));
  sides_ = std::move(sides);
  preset_ = preset;
}

void Session::toggle_side_by_side() {
  if (!sides_) return start_sides(contrast_for(*simulation_));
  sides_.reset();
  past_.begin(shown());
  pacer_.forgive();
}

/// With the left side's own value where the one proposed cannot be built: another can then be typed.
void Session::differ_in(const std::string& contrast) {
  try {
    choose(contrast_in(*simulation_, contrast));
  } catch (const BadInput&) {
    choose({contrast, value_of(*simulation_, contrast)});
  }
}

void Session::put_beside(const std::string& contrast, const std::string& value) {
  const auto known = contrasts(*simulation_);
  if (std::find(known.begin(), known.end(), contrast) == known.end())
    throw BadInput(unknown_name("parameter", contrast, known));
  const auto values = contrast_values(*simulation_, contrast);
  if (!values.empty() && std::find(values.begin(), values.end(), value) == values.end())
    throw BadInput(unknown_name(contrast, value, values));
  choose({contrast, value});
}

void Session::choose_other(const std::string& value) {
  if (sides_) choose({sides_->contrast().name, value});
}

void Session::choose(const Contrast& contrast) {
  start_sides(contrast);
  contrast_ = contrast;
}

/// Of a live parameter, on the left and, unless the sides differ in it, on the right.
void Session::set_both(const std::string& parameter, const std::string& value) {
  auto& right = *sides_->right().simulation;
  const bool both = sides_->contrast().name != parameter && right.parameters().find(parameter) != nullptr;
  if (both) Parameters(right.parameters()).set(parameter, value, Origin::window);  // or throws
  sides_->level();
  simulation_->set(parameter, value);
  if (both) right.set(parameter, value);
  sides_->changed();
}

void Session::act_on_both(const std::function<void(Simulation&)>& act) {
  if (sides_) sides_->level();
  act(*simulation_);
  if (!sides_) return;
  act(*sides_->right().simulation);
  sides_->changed();
}

/// Counts what `act` does to both; the work is that of the left side.
template <class Act>
void Session::act_on_sides(const Act& act) {
  const long steps = simulation_->steps();
  const double time = simulation_->time(), cpu = sides_->left().cpu_seconds;
  const bool before_end = until_ && sides_->time() < *until_;
  sides_->end_at(before_end ? *until_ : std::numeric_limits<double>::infinity());
  work_.within_budget = act();
  diverged_ = sides_->left().divergence;
  work_.steps = simulation_->steps() - steps;
  work_.simulated = simulation_->time() - time;
  work_.seconds = sides_->left().cpu_seconds - cpu;
  if (work_.steps > 0 && !diverged_) history_.add(*simulation_);
  if (before_end && sides_->time() >= *until_) paused_ = true;
  if (work_.steps > 0 && steps_until_ && steps < *steps_until_ && simulation_->steps() >= *steps_until_)
    paused_ = true;
}

}  // namespace clapotis
