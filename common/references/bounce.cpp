#include "common/references/bounce.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "common/references/require.hpp"

namespace clapotis {

namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();
constexpr double round_off = std::numeric_limits<double>::epsilon();
constexpr int impacts_one_by_one = 5000;

void check(const BouncingBall& b) {
  const auto demand = [](bool holds, const char* name, double value, const char* range) {
    require(holds, "BouncingBall", name, value, range);
  };
  demand(b.height >= 0 && std::isfinite(b.height), "height [m]", b.height, "finite and >= 0");
  demand(std::isfinite(b.speed), "speed [m/s]", b.speed, "finite");
  demand(b.gravity >= 0 && std::isfinite(b.gravity), "gravity [m/s^2]", b.gravity, "finite and >= 0");
  demand(b.drag_time > 0, "drag_time [s]", b.drag_time, "> 0 (infinity: no drag)");
  demand(b.restitution >= 0 && b.restitution <= 1, "restitution", b.restitution, "from 0 to 1");
}

Fall flight(const BouncingBall& b, const Impact& from) { return {0, from.v_after, b.gravity, b.drag_time}; }

/// The impact of a ball that comes down with speed v.
Impact meet(const BouncingBall& b, double time, double v) { return {time, v, -b.restitution * v}; }

Impact first_impact(const BouncingBall& b) {
  const Fall fall{b.height, b.speed, b.gravity, b.drag_time};
  const double time = b.height == 0 && b.speed == 0 ? infinity : fall.landing_time();
  return std::isinf(time) ? Impact{infinity, 0, 0} : meet(b, time, std::min(fall.at(time).v, 0.0));
}

/// The impact m flights after `from`, in closed form.
/// Without drag, launch speeds u and flights 2u/g are geometric. With drag, alpha = u/(g tau) of the launches
/// obeys 1/alpha' = (1/alpha + 2/3 + 4/135 alpha^2 + ...)/e, found by expanding (1 + alpha)(1 - exp(-s)) = s.
/// Without its last term the recurrence has a solution; the flights s = alpha + alpha'/e are summed by Euler
/// and Maclaurin.
Impact jump(const BouncingBall& b, const Impact& from, double m) {
  const double e = b.restitution;
  const double rate = -std::log(e);
  const double faded = e == 1 ? m : -std::expm1(-rate * m) / rate;  // integral of e^k over 0 < k < m
  const double scale = e == 1 ? 1 : rate / (1 - e);
  const double remains = e == 1 ? 1 : std::exp(-rate * m);
  if (std::isinf(b.drag_time)) {
    const double time = from.time + 2 * from.v_after / b.gravity * scale * faded;
    return {time, -from.v_after * remains / e, from.v_after * remains};
  }
  const double start = from.v_after / (b.gravity * b.drag_time);
  const double q = 2.0 / 3 * scale;
  const double alpha = start * remains / (1 + q * faded * start);
  const double sum_of_alpha = std::log1p(q * faded * start) / q - (alpha - start) / 2 -
                              (alpha - start) * (rate + q * (alpha + start)) / 12;
  const double flights = (1 + 1 / e) * sum_of_alpha + (alpha - start) / e;
  const double u = alpha * b.gravity * b.drag_time;
  return {from.time + b.drag_time * flights, -u / e, u};
}

struct Walk {
  Impact last;
  int count;     // number of `last`
  bool settled;  // all that follows is shorter than the round-off of the clock
};

/// Impact after impact up to number `most` or time t. The clock that adds up thousands of shorter and shorter
/// flights is a long double: Kahan's correction would not survive a compiler that may reorder sums.
Walk walk(const BouncingBall& b, const Impact& first, int most, double t) {
  Walk w{first, 1, false};
  long double clock = first.time;
  while (w.count < most) {
    const Fall fall = flight(b, w.last);
    const double duration = fall.landing_time();
    w.settled = duration <= round_off / 4 * w.last.time * (1 - b.restitution);
    if (w.settled) break;
    clock += duration;
    const double time = static_cast<double>(clock);
    if (time > t) break;
    w.last = meet(b, time, fall.at(duration).v);
    ++w.count;
  }
  return w;
}

/// Impacts to take one by one before `jump` is right: none without drag.
int most_steps(const BouncingBall& b) { return std::isinf(b.drag_time) ? 1 : impacts_one_by_one; }

/// Round-off can put the end of a flight a few 1e-16 below the floor.
BallState above_floor(const BallState& state) { return {std::max(state.y, 0.0), state.v}; }

BallState fly(const BouncingBall& b, const Impact& from, double t) {
  return above_floor(flight(b, from).at(t - from.time));
}

}  // namespace

Impact BouncingBall::impact(int n) const {
  check(*this);
  require(n >= 1, "BouncingBall", "number of the impact", n, ">= 1");
  const Impact first = first_impact(*this);
  if (n == 1 || std::isinf(first.time)) return first;
  if (first.v_after == 0 || gravity == 0) return {infinity, 0, 0};
  const Walk w = walk(*this, first, std::min(n, most_steps(*this)), infinity);
  const int missing = n - w.count;
  if (missing == 0) return w.last;
  if (!w.settled) return jump(*this, w.last, missing);
  return meet(*this, w.last.time, w.last.v_before * std::pow(restitution, missing));
}

double BouncingBall::rest_time() const {
  check(*this);
  if (height == 0 && speed == 0) return 0;
  const Impact first = first_impact(*this);
  if (std::isinf(first.time) || first.v_after == 0) return first.time;
  if (gravity == 0 || restitution == 1) return infinity;
  const Walk w = walk(*this, first, most_steps(*this), infinity);
  return w.settled ? w.last.time : jump(*this, w.last, infinity).time;
}

BallState BouncingBall::at(double t) const {
  check(*this);
  require(t >= 0 && std::isfinite(t), "BouncingBall", "t [s]", t, "finite and >= 0");
  if (height == 0 && speed == 0) return {0, 0};
  const Impact first = first_impact(*this);
  if (t < first.time) return above_floor(Fall{height, speed, gravity, drag_time}.at(t));
  if (first.v_after == 0) return {0, 0};
  if (gravity == 0) return fly(*this, first, t);

  const int most = most_steps(*this);
  const Walk w = walk(*this, first, most, t);
  if (w.settled) return {0, 0};
  if (w.count < most) return fly(*this, w.last, t);
  if (restitution < 1 && jump(*this, w.last, infinity).time <= t) return {0, 0};

  // The last impact before t: double the number of flights until it is passed, then bisect.
  double few = 0, many = 1;
  while (jump(*this, w.last, many).time <= t) many *= 2;
  if (many * round_off > 1) return {0, 0};  // flights shorter than the round-off of t
  while (many - few > 1) {
    const double middle = std::floor((few + many) / 2);
    (jump(*this, w.last, middle).time <= t ? few : many) = middle;
  }
  return fly(*this, jump(*this, w.last, few), t);
}

}  // namespace clapotis
