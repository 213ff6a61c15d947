#include "common/runner/comparison.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "common/runner/interrupt.hpp"
#include "common/runner/timing.hpp"
#include "common/words.hpp"

namespace clapotis {
namespace {

constexpr double rounding = 1e-6;  ///< share of a step by which an instant may be missed

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

void refuse_other_units(const Simulation& a, const Simulation& b) {
  if (a.scene().length_unit != b.scene().length_unit)
    throw BadInput(say(words().compare_units, fmt::arg("left", a.scene().length_unit),
                       fmt::arg("right", b.scene().length_unit)));
}

bool same_particles(const Particles& a, const Particles& b) {
  return a.size() == b.size() && a.ids() == b.ids();
}

}  // namespace

double Side::cost() const {
  return simulation->time() > 0 ? 1e3 * cpu_seconds / simulation->time()
                                : std::numeric_limits<double>::quiet_NaN();
}

double Side::energy_drift() const {
  const double start = history.first().energy.total();
  return (history.latest().energy.total() - start) / (start == 0 ? 1 : std::abs(start));
}

double time_of_both(const Side& left, const Side& right) {
  const double l = left.simulation->time(), r = right.simulation->time();
  if (left.runs() == right.runs()) return left.runs() ? std::min(l, r) : std::max(l, r);
  return left.runs() ? l : r;
}

Difference distances(const Vectors& left, const Vectors& right, double time) {
  const Column squared = (left - right).square().rowwise().sum();
  Difference d{.time = time};
  if (squared.size() == 0) return d;
  d.largest = std::sqrt(squared.maxCoeff(&d.particle));
  d.rms = std::sqrt(squared.mean());
  return d;
}

Comparison::Comparison(Side& left, Side& right, double until, double interval)
    : left_{.side = &left, .noted = {}, .position = {}, .velocity = {}},
      right_{.side = &right, .noted = {}, .position = {}, .velocity = {}},
      until_(until),
      interval_(interval),
      diagonal_(diagonal_of(left.simulation->setup().view)) {
  const auto &a = *left.simulation, &b = *right.simulation;
  refuse_other_units(a, b);
  decide_steps();
  if (interval_ <= 0) {
    const double dt = std::max(a.dt(), b.dt()), usual = usual_interval(dt, until, a.particles().size());
    interval_ = together_ ? usual : std::max(usual, dt);
  }
  rows_ = Cadence(interval_);
  if (same_particles(a.particles(), b.particles()))
    start_ = distances(a.particles().position, b.particles().position, 0);
  now_ = start_;
  largest_ = start_.value_or(Difference{});
  for (auto* side : {&left, &right}) side->history.add(*side->simulation);
}

/// Whether every step of the one is a step of the other.
void Comparison::decide_steps() {
  const auto &a = *left_.side->simulation, &b = *right_.side->simulation;
  together_ = a.dt() == b.dt() && a.time() == b.time() && !a.model().limits_follow_state() &&
              !b.model().limits_follow_state();
}

void Comparison::reconsider() {
  auto &a = *left_.side->simulation, &b = *right_.side->simulation;
  const double dt = std::max(a.dt(), b.dt());
  decide_steps();
  for (auto* trace : {&left_, &right_}) trace->noted.clear(), trace->at_row = false;
  if (!together_ && interval_ < dt) rows_ = Cadence(interval_ = dt);
  rows_.serve(std::max(a.time(), b.time()), dt);
}

Comparison::Piece Comparison::advance_to(double target) {
  const Index numbers = 2 * std::max<Index>(1, left_.side->simulation->particles().size());
  const long most = together_ ? std::max<Index>(1, most_noted / numbers) : std::numeric_limits<long>::max();
  const auto allows = [] { return !Interrupt::asked(); };
  while (allows()) {
    const auto piece = advance_a_piece(target, most, allows);
    if (piece != Piece::steps) return piece;
  }
  return Piece::nothing;
}

Comparison::Piece Comparison::advance_a_piece(double target, long most, const Allows& allows) {
  Trace* behind = nullptr;
  const auto time = [](const Trace& trace) { return trace.side->simulation->time(); };
  for (auto* trace : {&left_, &right_})
    if (may_step(*trace, target) && (behind == nullptr || time(*trace) < time(*behind))) behind = trace;
  if (behind == nullptr) return finish_row();
  stepped_ = true;
  try {
    const Timing timing(behind->side->cpu_seconds);
    long steps = 0;
    do step(*behind);
    while (++steps < most && may_step(*behind, target) && allows());
  } catch (const Diverged& reason) {
    behind->side->divergence = reason;
  }
  match();
  return Piece::steps;
}

/// When the sides are compared next unless it is after each step.
double Comparison::instant() const { return std::min(rows_.next(), until_); }

bool Comparison::may_step(const Trace& trace, double target) const {
  const auto& s = *trace.side->simulation;
  return trace.side->runs() && !trace.at_row && s.time() < until_ &&
         s.time() + (1 - rounding) * s.dt() <= target;
}

void Comparison::step(Trace& trace) const {
  auto& s = *trace.side->simulation;
  if (together_) {
    s.step(until_);
    trace.noted.push_back({s.time(), s.particles().position, s.particles().ids()});
    trace.at_row = rows_.due(s.time(), s.dt());
    return;
  }
  if (s.time() + 2 * s.dt() >= instant()) {
    trace.position = s.particles().position;
    trace.velocity = s.particles().velocity;
    trace.time = s.time();
  }
  s.step(until_);
  if (s.time() >= instant()) note_instant(trace);
}

/// Where the particles were at the instant that the last step has passed: not known where it took some away.
void Comparison::note_instant(Trace& trace) const {
  const auto& s = *trace.side->simulation;
  const auto& now = s.particles();
  const double dt = s.time() - trace.time;
  trace.at_row = true;
  if (trace.position.rows() != now.size()) return;
  trace.noted.push_back({instant(),
                         s.time() > instant() ? between(trace.position, trace.velocity, now.position,
                                                        now.velocity, dt, (instant() - trace.time) / dt)
                                              : now.position,
                         now.ids()});
}

/// Compares all that both sides have noted.
void Comparison::match() {
  auto &left = left_.noted, &right = right_.noted;
  for (; !left.empty() && !right.empty(); left.pop_front(), right.pop_front()) {
    const auto &a = left.front(), &b = right.front();
    now_.reset();
    if (a.positions.rows() != b.positions.rows() || a.ids != b.ids) continue;
    now_ = distances(a.positions, b.positions, a.time);
    if (!a.ids.empty()) now_->particle = a.ids[static_cast<std::size_t>(now_->particle)];
    if (now_->largest > largest_.largest) largest_ = *now_;
  }
  if (left_.side->runs() && right_.side->runs()) return;
  left.clear();
  right.clear();
}

Comparison::Piece Comparison::finish_row() {
  const auto waits = [&](const Trace& trace) {
    return !trace.side->runs() || trace.at_row || trace.side->simulation->time() >= until_;
  };
  if (!stepped_ || !waits(left_) || !waits(right_)) return Piece::nothing;
  const auto &a = *left_.side->simulation, &b = *right_.side->simulation;
  const bool one_runs = left_.side->runs() || right_.side->runs();
  const double furthest = std::max(left_.side->runs() ? a.time() : 0, right_.side->runs() ? b.time() : 0);
  if (one_runs) time_ = together_ ? furthest : instant();
  const bool nothing_new = !now_ || now_->time < time_;  // one has diverged, or has lost particles just now
  if (!left_.side->runs() || !right_.side->runs() || nothing_new) now_.reset();
  rows_.serve(together_ ? time_ : std::max(time_, furthest), a.dt());
  for (auto* trace : {&left_, &right_}) {
    trace->at_row = false;
    trace->noted.clear();
    if (trace->side->runs()) trace->side->history.add(*trace->side->simulation);
  }
  stepped_ = false;
  wait_at_end();
  return Piece::row;
}

/// A step that has passed the row may have brought a side to the end already: the end is compared, too.
void Comparison::wait_at_end() {
  if (together_) return;
  for (auto* trace : {&left_, &right_}) {
    const auto& s = *trace->side->simulation;
    if (!trace->side->runs() || s.time() < until_ || time_ + rounding * s.dt() >= until_) continue;
    note_instant(*trace);
    stepped_ = true;
  }
  match();
}

}  // namespace clapotis
