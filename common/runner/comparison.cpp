#include "common/runner/comparison.hpp"

#include <algorithm>
#include <cmath>

#include "common/runner/interrupt.hpp"
#include "common/runner/timing.hpp"
#include "common/simulation/errors.hpp"
#include "common/words.hpp"

namespace clapotis {
namespace {

/// How many numbers a side may note before the other catches up.
constexpr Index most_noted = 1 << 20;

/// The cubic through positions r0, r1 with velocities v0, v1, a share s of the step of length dt on.
Vectors between(const Vectors& r0, const Vectors& v0, const Vectors& r1, const Vectors& v1, double dt,
                double s) {
  const double s2 = s * s, s3 = s2 * s;
  return (2 * s3 - 3 * s2 + 1) * r0 + (s3 - 2 * s2 + s) * dt * v0 + (3 * s2 - 2 * s3) * r1 +
         (s3 - s2) * dt * v1;
}

double diagonal_of(const View2D& view) { return std::hypot(view.right - view.left, view.top - view.bottom); }

void refuse_unlike(const Side& left, const Side& right) {
  const auto &a = *left.simulation, &b = *right.simulation;
  if (a.scene().length_unit != b.scene().length_unit)
    throw BadInput(say(words().compare_units, fmt::arg("left", a.scene().length_unit),
                       fmt::arg("right", b.scene().length_unit)));
  if (a.particles().size() != b.particles().size())
    throw BadInput(say(words().compare_counts, fmt::arg("left", a.particles().size()),
                       fmt::arg("right", b.particles().size())));
}

double usual_interval_of(const Side& left, const Side& right, double until, bool together) {
  const double dt = std::max(left.simulation->dt(), right.simulation->dt());
  const double usual = usual_interval(dt, until, left.simulation->particles().size());
  return together ? usual : std::max(usual, dt);
}

}  // namespace

/// The positions of one side at the instants up to the next row.
struct Comparison::Trace {
  std::vector<double> times;
  std::vector<Vectors> positions;
};

Difference distances(const Vectors& left, const Vectors& right, double time) {
  const Column squared = (left - right).square().rowwise().sum();
  Difference d{.time = time};
  if (squared.size() == 0) return d;
  d.largest = std::sqrt(squared.maxCoeff(&d.particle));
  d.rms = std::sqrt(squared.mean());
  return d;
}

Comparison::Comparison(Side& left, Side& right, double until, double interval)
    : left_(left),
      right_(right),
      until_(until),
      interval_(interval),
      diagonal_(diagonal_of(left.simulation->setup().view)),
      together_(left.simulation->dt() == right.simulation->dt() &&
                !left.simulation->model().limits_follow_state() &&
                !right.simulation->model().limits_follow_state()),
      rows_(0) {
  refuse_unlike(left, right);
  if (interval_ <= 0) interval_ = usual_interval_of(left, right, until, together_);
  rows_ = Cadence(interval_);
  start_ = distances(left.simulation->particles().position, right.simulation->particles().position, 0);
  now_ = largest_ = start_;
  for (auto* side : {&left_, &right_}) side->history.add(*side->simulation);
}

bool Comparison::advance() {
  const auto goes_on = [&](const Side& side) { return side.runs() && side.simulation->time() < until_; };
  const auto has_ended = [&] { return Interrupt::asked() || (!goes_on(left_) && !goes_on(right_)); };
  if (has_ended()) return false;
  do {
    Trace left, right;
    follow(left_, left);
    follow(right_, right);
    note(left, right);
  } while (!rows_.due(time_, left_.simulation->dt()) && !has_ended());
  rows_.serve(time_, left_.simulation->dt());
  for (auto* side : {&left_, &right_})
    if (side->runs()) side->history.add(*side->simulation);
  return true;
}

/// To the next row, or until the side diverges.
void Comparison::follow(Side& side, Trace& trace) const {
  if (!side.runs()) return;
  const Timing timing(side.cpu_seconds);
  try {
    if (together_) {
      step_together(side, trace);
    } else {
      reach_instant(side, trace);
    }
  } catch (const Diverged& error) {
    side.divergence = error.what();
  }
}

void Comparison::step_together(Side& side, Trace& trace) const {
  auto& s = *side.simulation;
  const auto most =
      static_cast<std::size_t>(std::max<Index>(1, most_noted / std::max<Index>(1, 2 * s.particles().size())));
  do {
    s.step(until_);
    trace.times.push_back(s.time());
    trace.positions.push_back(s.particles().position);
  } while (s.time() < until_ && !rows_.due(s.time(), s.dt()) && trace.times.size() < most &&
           !Interrupt::asked());
}

void Comparison::reach_instant(Side& side, Trace& trace) const {
  auto& s = *side.simulation;
  const double instant = std::min(rows_.next(), until_);
  while (s.time() + 2 * s.dt() < instant && !Interrupt::asked()) s.step(until_);
  if (Interrupt::asked()) return;
  Vectors position = s.particles().position, velocity = s.particles().velocity;
  double time = s.time();
  while (s.time() < instant) {
    position = s.particles().position;
    velocity = s.particles().velocity;
    time = s.time();
    s.step(until_);
  }
  const double dt = s.time() - time;
  trace.times.push_back(instant);
  trace.positions.push_back(dt > 0 && s.time() > instant
                                ? between(position, velocity, s.particles().position, s.particles().velocity,
                                          dt, (instant - time) / dt)
                                : s.particles().position);
}

void Comparison::note(const Trace& left, const Trace& right) {
  const auto common = std::min(left.times.size(), right.times.size());
  for (std::size_t k = 0; k < common; ++k) {
    now_ = distances(left.positions[k], right.positions[k], left.times[k]);
    if (now_->largest > largest_.largest) largest_ = *now_;
  }
  const auto& longer = left.times.size() >= right.times.size() ? left.times : right.times;
  if (!longer.empty()) time_ = longer.back();
  if (!left_.runs() || !right_.runs()) now_.reset();
}

}  // namespace clapotis
