#include "common/simulation/simulation.hpp"

#include <chrono>
#include <cmath>
#include <limits>

#include "common/integrators/bogacki_shampine.hpp"
#include "common/integrators/located_impacts.hpp"
#include "common/simulation/errors.hpp"
#include "common/simulation/time_step.hpp"
#include "common/words.hpp"

namespace clapotis {
namespace {

constexpr std::size_t checkpoint_every = 16;  // steps: a copy of the state costs a few per cent of one step
constexpr long timed_every = 8;               // steps: reading the clock costs as much as moving a particle

double seconds_since(std::chrono::steady_clock::time_point start) {
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
}

std::string about(std::string_view sentence, double dt, const StepLimit& limit) {
  return say(sentence, fmt::arg("dt", fmt::format("{:.4g}", dt)),
             fmt::arg("ratio", fmt::format("{:.3g}", dt / limit.limit)),
             fmt::arg("limit", called(limit.name, Naming::limit)), fmt::arg("formula", limit.formula));
}

}  // namespace

/// A state to go back to. The steps from it to any later one can be repeated bit for bit.
struct Simulation::Checkpoint {
  Particles particles;
  double time, dissipated, dissipation;
  bool current;
  long force_evaluations, steps, entered, left;
  Clock clock;
  long long coincident, folded;
};

Simulation::Simulation(const Scene& scene, const Overrides& overrides, std::string_view integrator,
                       int threads)
    : scene_(scene),
      built_from_(overrides),
      parameters_(scene.length_unit, scene.defaults, overrides),
      setup_(scene.build(parameters_)) {
  parameters_.number(step_parameter);
  parameters_.number(cfl_parameter);
  if (setup_.matter() == Matter::particles) parameters_.number(tolerance_parameter);
  parameters_.reject_unknown();
  if (threads < 1) throw BadInput(say(words().threads_out_of_range, fmt::arg("value", threads)));
  reference_ = setup_.reference;
  setup_.particles.threads = threads;
  system_ = std::make_unique<System>(std::move(setup_.particles), *setup_.model);
  use_integrator(integrator);
  if (setup_.fluid) {  // its density and accelerations count from the start
    system_->evaluate(0);
    system_->current = true;
  }
  choose_step();
  bound_speed();
  if (const auto* broken = broken_limit(dt_, limits_); broken != nullptr && !integrator_->controls_error())
    warnings_.push_back(about(words().beyond_limit, dt_, *broken));
  keep();
}

Simulation::~Simulation() = default;

void Simulation::use_integrator(std::string_view name) {
  auto scheme = make_integrator(name, setup_.matter());
  integrator_.reset();
  integrator_ = setup_.locate_impacts ? std::make_unique<LocatedImpacts>(std::move(scheme), *system_)
                                      : std::move(scheme);
  integrator_->read(parameters_);
  integrator_name_ = name;
  ++interventions_;
  system_->current = false;
  if (checkpoint_) keep();
}

/// Changes nothing if it throws.
void Simulation::choose_step() {
  auto limits = setup_.model->limits(particles());
  const double c = setup_.fluid ? setup_.fluid->state.sound_speed : falling_sound_speed(parameters_);
  if (!setup_.fluid)
    limits.insert(limits.begin(), acoustic_limit(setup_.radius, c, parameters_.number(cfl_parameter)));
  dt_ = choose_dt(parameters_.number(step_parameter), limits);
  limits_ = std::move(limits);
  sound_speed_ = c;
}

/// From what is there at the start, or after a change by hand. What a run brings by itself must not raise it:
/// speeds that grow step by step would never be too high.
void Simulation::bound_speed() {
  // what the springs hold, and what a heavy particle moves with, may become the speed of the lightest
  const double least = particles().least_mass(), heavier = std::sqrt(particles().greatest_mass() / least);
  const double v = heavier * max_speed(particles());
  const double elastic = setup_.model->stored_energy(particles()).elastic;
  fastest_ = std::max({fastest_, heavier * sound_speed_, 10 * std::sqrt(v * v + 2 * elastic / least)});
}

const StepLimit& Simulation::binding_limit() const { return binding(limits_); }

void Simulation::set(std::string_view name, std::string_view value, Origin origin) {
  const auto* known = parameters_.find(name);
  if (known != nullptr && known->change == Change::restart)
    throw BadInput(say(words().needs_restart, fmt::arg("name", name)));
  const auto before = parameters_;
  try {
    parameters_.set(name, value, origin);
    setup_.model->refresh(parameters_);
    integrator_->read(parameters_);
    choose_step();
    bound_speed();
  } catch (...) {
    parameters_ = before;
    setup_.model->refresh(parameters_);
    integrator_->read(parameters_);
    throw;
  }
  if (changes_.empty()) unchanged_ = before;
  note_change(name, value, origin);
  ++interventions_;
  system_->current = false;
  keep();
}

void Simulation::edit(const std::function<void(System&)>& change) {
  auto& s = *system_;
  const double before = energy().mechanical();
  change(s);
  ++interventions_;
  s.dissipated_energy += before - energy().mechanical();
  setup_.reference.reset();
  s.evaluate(s.time);
  s.current = true;
  choose_step();
  bound_speed();
  keep();
}

void Simulation::step(double until) {
  const double left = until - time();
  const double dt = next_ends_at(until) ? left : dt_;
  if (dt <= 0) return;
  if (taken_.size() >= checkpoint_every) keep();
  taken_.push_back(dt);
  advance(dt);
  if (dt == left) {
    system_->time = until;
    clock_ = {};
  }
  check(dt);
  if (dt == left) keep();  // the way back knows nothing of `until`
  if (setup_.model->limits_follow_state()) choose_step();
}

void Simulation::advance(double dt) {
  auto& s = *system_;
  auto& model = *setup_.model;
  model.timed = steps_ % timed_every == 0;
  const auto start = std::chrono::steady_clock::now();
  if (!s.current) s.evaluate(s.time);
  s.current = true;
  integrator_->step(s, dt);
  const double integrated = model.timed ? seconds_since(start) - model.seconds.total() : 0;
  model.settle(s, dt);
  s.current = integrator_->leaves_acceleration();
  if (dt != clock_.dt) clock_ = {s.time, dt, 0};
  s.time = clock_.start + static_cast<double>(++clock_.steps) * dt;
  ++steps_;
  if (model.timed) {
    const double settled = seconds_since(start);
    cost_.neighbours += timed_every * model.seconds.neighbours;
    cost_.density += timed_every * model.seconds.density;
    cost_.forces += timed_every * model.seconds.forces;
    cost_.integration += timed_every * integrated;
    cost_.walls += timed_every * (settled - integrated - model.seconds.total() + model.seconds.walls);
    model.seconds = {};
    model.timed = false;  // what comes between two steps does not count
  }
}

void Simulation::check(double dt) {
  const double speed = max_speed(particles());
  const auto& density = particles().density;
  const bool finite = std::isfinite(speed) && particles().finite();
  if (finite && (speed <= fastest_ || fastest_ == 0)) return;

  Index particle = 0;
  for (Index i = 0; i < particles().size(); ++i) {
    const Vector r = row(particles().position, i), v = row(particles().velocity, i);
    const double rho = density.size() > 0 ? density(i) : 0;
    if (finite ? dot(v, v) > fastest_ * fastest_
               : !std::isfinite(dot(v, v)) || !std::isfinite(r.x + r.y + rho)) {
      particle = i;
      break;
    }
  }
  const auto* broken = broken_limit(dt, limits_);
  const auto cause = (finite ? say(words().diverged_speed, fmt::arg("speed", fmt::format("{:.3g}", speed)),
                                   fmt::arg("bound", fmt::format("{:.3g}", fastest_)),
                                   fmt::arg("unit", scene_.length_unit + "/s"))
                             : std::string(words().diverged_nan)) +
                     (broken != nullptr ? about(words().cause_limit, dt, *broken)
                                        : say(words().cause_scheme, fmt::arg("integrator", integrator_name_),
                                              fmt::arg("dt", fmt::format("{:.4g}", dt))));
  const long step = steps_;
  const double t = time();
  const Index id = particles().id(particle);
  go_back(step - 1);
  throw Diverged(say(words().diverged, fmt::arg("step", step), fmt::arg("time", fmt::format("{:.6g}", t)),
                     fmt::arg("particle", id), fmt::arg("cause", cause)),
                 step, t, id);
}

void Simulation::keep() {
  if (!checkpoint_) checkpoint_ = std::make_unique<Checkpoint>();
  const auto& s = *system_;
  auto& c = *checkpoint_;
  c.particles = s.particles;
  c.time = s.time;
  c.dissipated = s.dissipated_energy;
  c.dissipation = s.dissipation;
  c.current = s.current;
  c.force_evaluations = s.force_evaluations;
  c.entered = s.entered;
  c.left = s.left;
  c.steps = steps_;
  c.clock = clock_;
  c.coincident = s.model.coincident;
  c.folded = s.model.folded;
  taken_.clear();
}

/// Back to the checkpoint, then forward again, by the same steps, to the state after `steps` of them.
void Simulation::go_back(long steps) {
  auto& s = *system_;
  const auto& c = *checkpoint_;
  s.particles = c.particles;
  s.time = c.time;
  s.dissipated_energy = c.dissipated;
  s.dissipation = c.dissipation;
  s.current = c.current;
  s.force_evaluations = c.force_evaluations;
  s.entered = c.entered;
  s.left = c.left;
  clock_ = c.clock;
  s.model.coincident = c.coincident;
  s.model.folded = c.folded;
  const auto again = std::move(taken_);
  taken_.clear();
  for (steps_ = c.steps; steps_ < steps;) {
    taken_.push_back(again[taken_.size()]);
    advance(taken_.back());
  }
}

void Simulation::look(const std::function<void(const System&)>& look) {
  auto& s = *system_;
  const Vectors acceleration = s.acceleration;
  const double dissipation = s.dissipation;
  const auto coincident = s.model.coincident;
  s.model.evaluate(s, s.time);
  s.model.coincident = coincident;
  look(s);
  s.acceleration = acceleration;
  s.dissipation = dissipation;
}

double Simulation::error() const {
  return setup_.reference ? setup_.reference->error(*system_) : std::numeric_limits<double>::quiet_NaN();
}

std::vector<std::string> Simulation::warnings() const {
  auto all = warnings_;
  if (model().coincident > 0)
    all.push_back(say(setup_.fluid ? words().warn_coincident_fluid : words().warn_coincident,
                      fmt::arg("count", model().coincident)));
  if (model().folded > 0) all.push_back(say(words().warn_folded, fmt::arg("count", model().folded)));
  return all;
}

double Simulation::bytes_per_particle() const {
  return static_cast<double>(particles().bytes() + model().bytes()) /
         static_cast<double>(std::max<Index>(particles().size(), 1));
}

}  // namespace clapotis
