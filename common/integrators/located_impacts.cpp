#include "common/integrators/located_impacts.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "common/simulation/model.hpp"

namespace clapotis {

LocatedImpacts::LocatedImpacts(std::unique_ptr<Integrator> scheme, System& system)
    : scheme_(std::move(scheme)), s_(system) {
  s_.bear = [this](System&) { bear(); };
}

LocatedImpacts::~LocatedImpacts() { s_.bear = nullptr; }

LocatedImpacts::State LocatedImpacts::state() const {
  return {row(s_.position, 0), row(s_.velocity, 0), s_.dissipated_energy};
}

void LocatedImpacts::put(const State& state) {
  s_.position.row(0) << state.r.x, state.r.y;
  s_.velocity.row(0) << state.v.x, state.v.y;
  s_.dissipated_energy = state.dissipated;
}

LocatedImpacts::Piece LocatedImpacts::begin(double t, double dt) {
  if (!s_.current) s_.evaluate(t);
  return {state(), row(s_.acceleration, 0), s_.dissipation, t, dt};
}

/// Advances by dt, at most the length of the piece, from its start; returns the state reached. The same dt
/// gives the same bits.
LocatedImpacts::State LocatedImpacts::run(const Piece& piece, double dt) {
  put(piece.from);
  s_.acceleration.row(0) << piece.a.x, piece.a.y;
  s_.dissipation = piece.dissipation;
  s_.time = piece.t;
  ran_ = dt;
  if (dt > 0) scheme_->step(s_, dt);
  return state();
}

double LocatedImpacts::gap(const State& state, const Side& side) const {
  const double r = side.axis == 0 ? state.r.x : state.r.y;
  return side.high ? walls_.high(side.axis) - r : r - walls_.low(side.axis);
}

/// Speed towards the wall.
double LocatedImpacts::closing(const State& state, const Side& side) {
  const double v = side.axis == 0 ? state.v.x : state.v.y;
  return side.high ? v : -v;
}

/// Where `value` of the state changes sign between `from` and `to`: regula falsi with the Illinois rule, and
/// bisection whenever that does not halve the bracket in three tries.
double LocatedImpacts::root(const Piece& piece, double from, double to,
                            const std::function<double(const State&)>& value) {
  const auto at = [&](double dt) { return value(run(piece, dt)); };
  double f_from = at(from), f_to = at(to), width = to - from;
  for (int tries = 0; tries < 200 && to - from > 4e-16 * piece.dt && f_to != 0; ++tries) {
    double middle = (from * f_to - to * f_from) / (f_to - f_from);
    if (tries % 3 == 2 || !(middle > from && middle < to)) {
      if (to - from > width / 2 || !(middle > from && middle < to)) middle = from + (to - from) / 2;
      width = to - from;
    }
    if (middle <= from || middle >= to) break;
    const double f = at(middle);
    if ((f < 0) == (f_to < 0)) {
      to = middle;
      f_to = f;
      f_from /= 2;
    } else {
      from = middle;
      f_from = f;
      f_to /= 2;
    }
  }
  return to;
}

double LocatedImpacts::impact_time(const Piece& piece, const State& end, const Side& side) {
  constexpr double never = std::numeric_limits<double>::infinity();
  if (contact_[static_cast<std::size_t>(side.axis)] != 0) return never;
  const double gap_start = gap(piece.from, side), gap_end = gap(end, side);
  const double closing_start = closing(piece.from, side), closing_end = closing(end, side);
  if (!std::isfinite(gap_start) || !std::isfinite(gap_end)) return never;

  const auto the_gap = [&](const State& s) { return gap(s, side); };
  const auto the_speed = [&](const State& s) { return closing(s, side); };
  if (gap_start <= 0 && (closing_start > 0 || (closing_start == 0 && gap_end < 0))) return 0;
  if (gap_end < 0) {
    // from the wall itself the flight leads away first: look beyond its turning point
    const double from = gap_start > 0 ? 0 : root(piece, 0, piece.dt, the_speed);
    return root(piece, from, piece.dt, the_gap);
  }
  const bool turned = closing_start > 0 && closing_end < 0 && gap_start < closing_start * piece.dt;
  if (!turned) return never;
  const double turning = root(piece, 0, piece.dt, the_speed);
  return gap(run(piece, turning), side) < 0 ? root(piece, 0, turning, the_gap) : never;
}

void LocatedImpacts::reflect(const Side& side, double rest_of_step) {
  const double wall = side.high ? walls_.high(side.axis) : walls_.low(side.axis);
  const double e = walls_.restitution, m = s_.particles.mass(0);
  s_.position(0, side.axis) = wall;
  const double before = s_.velocity(0, side.axis);
  s_.velocity(0, side.axis) = 0;  // what pushes a particle at rest against the wall?
  s_.model.evaluate(s_, s_.time);
  const double pushing = side.high ? s_.acceleration(0, side.axis) : -s_.acceleration(0, side.axis);
  const double speed = e * std::abs(before);
  const double until_rest = speed > 0 ? 2 * speed / (pushing * (1 - e)) : 0;  // infinite for e = 1
  if (pushing > 0 && until_rest <= rest_of_step)
    contact_[static_cast<std::size_t>(side.axis)] = side.high ? 1 : -1;
  else
    s_.velocity(0, side.axis) = side.high ? -speed : speed;
  const double after = s_.velocity(0, side.axis);
  s_.dissipated_energy += m / 2 * (before * before - after * after);
}

/// Whether the particle, at the start of a step, rests on a wall that the laws press it on.
void LocatedImpacts::rest_or_release() {
  contact_ = {0, 0};
  for (const int axis : {0, 1}) {
    const double r = s_.position(0, axis);
    if (s_.velocity(0, axis) == 0)
      contact_[static_cast<std::size_t>(axis)] = r == walls_.low(axis) ? -1 : r == walls_.high(axis) ? 1 : 0;
  }
  if (contact_ == Contact{0, 0}) return;
  s_.model.evaluate(s_, s_.time);
  for (const int axis : {0, 1}) {
    auto& side = contact_[static_cast<std::size_t>(axis)];
    if (side * s_.acceleration(0, axis) <= 0) side = 0;
  }
  s_.evaluate(s_.time);
  s_.current = true;
}

/// A wall bears what presses the resting particle on it.
void LocatedImpacts::bear() const {
  for (const int axis : {0, 1})
    if (contact_[static_cast<std::size_t>(axis)] * s_.acceleration(0, axis) > 0) s_.acceleration(0, axis) = 0;
}

void LocatedImpacts::step(System& s, double dt) {
  walls_ = *s.model.walls();
  touched_ = false;
  rest_or_release();
  const double start = s.time;
  auto piece = begin(start, dt);
  for (int impacts = 0; impacts <= most_impacts; ++impacts) {
    const auto end = run(piece, piece.dt);
    double times[2], first = std::numeric_limits<double>::infinity();
    Side sides[2];
    for (const int axis : {0, 1}) {
      const Side low{axis, false}, high{axis, true};
      const double to_low = impact_time(piece, end, low), to_high = impact_time(piece, end, high);
      sides[axis] = to_low <= to_high ? low : high;
      times[axis] = std::min(to_low, to_high);
      first = std::min(first, times[axis]);
    }
    if (first > piece.dt) {
      if (ran_ != piece.dt) run(piece, piece.dt);  // the search left another state behind
      return finish(start);
    }
    touched_ = true;
    run(piece, first);
    s.time = piece.t + first;
    for (const int axis : {0, 1})  // both at once in a corner
      if (times[axis] - first <= 1e-12 * dt) reflect(sides[axis], piece.dt - first);
    s.current = false;
    piece = begin(s.time, piece.dt - first);
  }
  count_remaining(piece);
  finish(start);
}

void LocatedImpacts::finish(double start) {
  s_.time = start;  // the clock is the caller's
  contact_ = {0, 0};
}

void LocatedImpacts::count_remaining(const Piece& piece) {
  for (const int axis : {0, 1}) {
    auto& r = s_.position(0, axis);
    auto& v = s_.velocity(0, axis);
    if (contact_[static_cast<std::size_t>(axis)] != 0) continue;
    const double a = axis == 0 ? piece.a.x : piece.a.y, low = walls_.low(axis), high = walls_.high(axis);
    const double away = r == low ? 1 : r == high ? -1 : 0;  // from the wall it is on
    const double push = -away * a, e = walls_.restitution;
    const bool hops = push > 0 && v * v < 2 * push * (high - low);
    const double last = hops ? v : v + a * piece.dt;  // at full speed
    const auto end =
        hops ? hop(away * v, push, piece.dt, e) : fold(r, (v + last) / 2, piece.dt, low, high, e);
    const double kept = std::pow(e, end.impacts);
    s_.dissipated_energy += s_.particles.mass(0) / 2 * last * last * (1 - kept * kept);
    r = hops ? r + away * end.position : end.position;
    v = hops ? away * end.velocity : end.impacts == 0 ? last : std::copysign(last * kept, end.velocity);
  }
  ++s_.model.folded;
}

}  // namespace clapotis
