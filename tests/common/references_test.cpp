#include <cmath>
#include <limits>
#include <stdexcept>
#include <utility>
#include <vector>

#include "common/references/bounce.hpp"
#include "common/references/fall.hpp"
#include "common/references/lambert_w.hpp"
#include "common/references/spring_pair.hpp"
#include "common/references/stack.hpp"
#include "tests/catch.hpp"

using namespace clapotis;

namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();
constexpr double round_off = std::numeric_limits<double>::epsilon();
constexpr double printed = 5e-13;  // half of the last of twelve printed decimals

BouncingBall ball_dropped_from_one_metre(double drag_time, double restitution = 0.8) {
  return {1, 0, 9.81, drag_time, restitution};
}

SpringPair unequal_pair() { return {1000, 0.1, 1, 3, -0.5, 0.4, 0.7, -0.2}; }

double momentum(const SpringPair& p, const SpringPair::State& s) { return p.mass1 * s.v1 + p.mass2 * s.v2; }

double energy(const SpringPair& p, const SpringPair::State& s) {
  const double overlap = std::fmax(0.0, 2 * p.radius - std::abs(s.x2 - s.x1));
  return (p.mass1 * s.v1 * s.v1 + p.mass2 * s.v2 * s.v2 + p.stiffness * overlap * overlap) / 2;
}

}  // namespace

TEST_CASE("Lambert's W solves w exp(w) = x from the branch point to 1e300", "[references]") {
  // A w right to 4 units in the last place moves w exp(w) by 4 (1 + w) of them.
  const auto solves = [](double x) {
    const double w = lambert_w0(x);
    CAPTURE(x, w);
    CHECK(w >= -1);
    CHECK(std::abs(w * std::exp(w) - x) <= 4 * round_off * (1 + std::abs(w)) * std::abs(x));
  };
  for (double x = 1e-300; x < 1e300; x *= 3) solves(x);
  for (double x = -1e-300; x > -0.36; x *= 1.1) solves(x);
  for (double above = 1e-16; above < 0.3; above *= 2) solves(-0.36787944117144233 + above);
  solves(1e300);
}

TEST_CASE("Lambert's W takes its published values and refuses what has none", "[references]") {
  CHECK(lambert_w0(0) == 0);
  CHECK(lambert_w0(1) == Approx(0.567143290409783873).epsilon(4 * round_off));  // the omega constant
  CHECK(lambert_w0(std::exp(1.0)) == Approx(1).epsilon(4 * round_off));
  CHECK(lambert_w0(-0.36787944117144) == Approx(-0.99999988771640612313).epsilon(4 * round_off));
  CHECK(lambert_w0(1e300) == Approx(684.24720862976084929).epsilon(4 * round_off));
  CHECK(lambert_w0(-0.36787944117144233) == Approx(-1).epsilon(2e-8));  // infinite slope: half of the digits
  CHECK(lambert_w0(infinity) == infinity);
  CHECK_THROWS_AS(lambert_w0(-0.37), std::invalid_argument);
  CHECK_THROWS_AS(lambert_w0(std::nan("")), std::invalid_argument);
}

TEST_CASE("a ball that falls in air obeys y' = v and v' = -g - v/tau", "[references]") {
  const double drag_time = GENERATE(0.1, 1.0, 100.0, 1e12, infinity);
  const Fall fall{1, 3, 9.81, drag_time};
  const double dt =
      1e-5;  // central differences: dt^2/6 v''' = 2e-7 at tau = 0.1, smaller above; round-off 1e-10
  for (double t = 0.05; t < 1.5; t += 0.1) {
    const BallState before = fall.at(t - dt), now = fall.at(t), after = fall.at(t + dt);
    CAPTURE(drag_time, t);
    CHECK(std::abs((after.y - before.y) / (2 * dt) - now.v) < 1e-6);
    CHECK(std::abs((after.v - before.v) / (2 * dt) + 9.81 + now.v / drag_time) < 1e-6);
  }
}

TEST_CASE("a flight of any length in air of any thickness ends on the floor", "[references]") {
  const double launch = GENERATE(1e-200, 1e-100, 1e-12, 1e-6, 1e-3, 0.1, 1.0, 10.0, 1e3, 1e6);
  const double drag_time = GENERATE(1e-3, 1.0, 1e3, 1e12, infinity);
  const Fall flight{0, launch, 9.81, drag_time};
  const double t = flight.landing_time();
  const BallState landed = flight.at(t);
  CAPTURE(launch, drag_time, t);
  CHECK(t > 0);
  CHECK(landed.v < 0);
  // The height is the difference of two terms of this size.
  CHECK(std::abs(landed.y) <= 8 * round_off * t * std::fmin(launch, launch * drag_time / t));
}

TEST_CASE("a ball thrown down faster than its terminal speed lands too", "[references]") {
  for (const double speed : {-10.0, -1e3, -1e8}) {
    const Fall fall{2, speed, 9.81, 0.1};
    CHECK(std::abs(fall.at(fall.landing_time()).y) <= 8 * round_off * std::fmin(2 - speed * 0.1, 10.0));
  }
}

TEST_CASE("a ball dropped from one metre meets the floor at the published times and speeds", "[references]") {
  const BouncingBall in_vacuum = ball_dropped_from_one_metre(infinity);
  const BouncingBall in_air = ball_dropped_from_one_metre(1);
  const std::vector<Impact> vacuum{{0.451523640986, -4.429446918070, 0},
                                   {1.173961466563, -3.543557534456, 0},
                                   {1.751911727025, -2.834846027565, 0}};
  const std::vector<Impact> air{{0.488217304865, -3.789411760724, 0},
                                {1.053323154142, -2.512158972833, 0},
                                {1.438400265720, -1.767879286311, 0}};
  for (int n = 1; n <= 3; ++n) {
    const auto row = static_cast<std::size_t>(n - 1);
    CAPTURE(n);
    CHECK(std::abs(in_vacuum.impact(n).time - vacuum[row].time) <= printed);
    CHECK(std::abs(in_vacuum.impact(n).v_before - vacuum[row].v_before) <= printed);
    CHECK(std::abs(in_air.impact(n).time - air[row].time) <= printed);
    CHECK(std::abs(in_air.impact(n).v_before - air[row].v_before) <= printed);
    CHECK(in_air.impact(n).v_after == -0.8 * in_air.impact(n).v_before);
  }
  CHECK(std::abs(in_vacuum.rest_time() - 4.063712768872) <= printed);
  CHECK(std::abs(in_air.rest_time() - 2.616236673911) <= printed);
}

TEST_CASE("a ball in air passes through the published states", "[references]") {
  const BouncingBall ball = ball_dropped_from_one_metre(1);
  CHECK(std::abs(ball.at(0.4).y - 0.310160348390) <= printed);
  CHECK(std::abs(ball.at(0.4).v + 3.234160348390) <= printed);
  CHECK(std::abs(ball.at(1.6).y - 0.089578362160) <= printed);
  CHECK(std::abs(ball.at(1.6).v + 0.260568326398) <= printed);
  CHECK(ball.at(2.7).y == 0);
  CHECK(ball.at(2.7).v == 0);
}

TEST_CASE("thin air changes a bounce by as little as it should, not by round-off over t/tau",
          "[references]") {
  // Third impacts from Lambert's W with 60 digits.
  CHECK(ball_dropped_from_one_metre(1e6).impact(3).time ==
        Approx(1.7519112834502389099).epsilon(8 * round_off));
  CHECK(ball_dropped_from_one_metre(1e9).impact(3).time ==
        Approx(1.7519117265810613257).epsilon(8 * round_off));
  CHECK(ball_dropped_from_one_metre(1e300).impact(3).time ==
        Approx(ball_dropped_from_one_metre(infinity).impact(3).time).epsilon(8 * round_off));
}

TEST_CASE("a ball is at the floor at each impact, with the speed that it leaves with", "[references]") {
  const double drag_time = GENERATE(0.3, 1.0, 1e3, infinity);
  const BouncingBall ball{1, 2, 9.81, drag_time, 0.9};
  for (int n = 1; n <= 40; ++n) {
    const Impact impact = ball.impact(n);
    const BallState just_before = ball.at(impact.time * (1 - 4 * round_off));
    const BallState just_after = ball.at(impact.time * (1 + 4 * round_off));
    CAPTURE(drag_time, n);
    // A shift of 4 round-offs of the clock, which itself may be wrong by a few.
    CHECK(std::abs(just_before.v - impact.v_before) < 1e-12);
    CHECK(std::abs(just_after.v - impact.v_after) < 1e-12);
    CHECK(just_after.y < 1e-13);
  }
}

TEST_CASE("a ball that loses no speed in its impacts keeps its energy and its rhythm for a million seconds",
          "[references]") {
  const BouncingBall ball = ball_dropped_from_one_metre(infinity, 1);
  const double period = 2 * std::sqrt(2 / 9.81);
  const double t = 1e6;
  const BallState state = ball.at(t);
  CHECK(state.v * state.v / 2 + 9.81 * state.y == Approx(9.81).epsilon(16 * round_off));
  // The period, right to half a round-off, is counted t/period times: 2e-10 s.
  const BallState first_round = ball.at(std::fmod(t, period));
  CHECK(std::abs(state.y - first_round.y) < 2e-9);
  CHECK(ball.rest_time() == infinity);
}

TEST_CASE("impacts by the ten thousand accumulate without losing the clock", "[references]") {
  const double restitution = GENERATE(0.999, 0.9999, 1.0);
  const BouncingBall ball = ball_dropped_from_one_metre(1, restitution);
  long double time = ball.impact(1).time;
  double launch = ball.impact(1).v_after;
  for (int n = 2; n <= 20000; ++n) {
    const Fall flight{0, launch, 9.81, 1};
    const double duration = flight.landing_time();
    time += duration;
    launch = -restitution * flight.at(duration).v;
    if (n == 2000) CHECK(ball.impact(n).time == Approx(static_cast<double>(time)).epsilon(4 * round_off));
  }
  const Impact impact = ball.impact(20000);
  CHECK(std::abs(impact.time - static_cast<double>(time)) < 1e-8);  // the closed form for small bounces
  CHECK(impact.v_after == Approx(launch).epsilon(1e-8));
  CHECK(std::abs(ball.at(impact.time).v) <= launch * (1 + 1e-7));
  CHECK(ball.rest_time() >= impact.time);
}

TEST_CASE("air and floor only ever take energy from the ball, also long after anyone can see it bounce",
          "[references]") {
  const double restitution = GENERATE(0.5, 0.99, 0.9999, 1.0);
  const BouncingBall ball = ball_dropped_from_one_metre(1, restitution);
  double energy_before = 9.81;
  for (double t = 0; t < 100; t += 0.613) {
    const BallState state = ball.at(t);
    const double energy = state.v * state.v / 2 + 9.81 * state.y;
    CAPTURE(restitution, t);
    CHECK(state.y >= 0);
    CHECK(energy <= energy_before * (1 + 1e-9) + 1e-30);  // the clock of late bounces: see the header
    energy_before = energy;
  }
}

TEST_CASE("a ball with nothing to bring it down, or back up, is described too", "[references]") {
  const auto never = [](const Impact& i) { return i.time == infinity && i.v_before == 0 && i.v_after == 0; };
  const BouncingBall afloat{1, 0, 0, infinity, 0.8}, rising{1, 2, 0, 1, 0.8}, lying{0, 0, 9.81, 1, 0.8};
  CHECK(never(afloat.impact(1)));
  CHECK(afloat.at(50).y == 1);
  CHECK(afloat.rest_time() == infinity);
  CHECK(never(rising.impact(1)));
  CHECK(rising.at(1e3).y == Approx(3));  // v0 tau further up
  CHECK(never(lying.impact(1)));
  CHECK(lying.at(3).y == 0);
  CHECK(lying.rest_time() == 0);

  const BouncingBall pushed_down{1, -2, 0, infinity, 0.5};  // one impact, then up for ever
  CHECK(pushed_down.impact(1).time == 0.5);
  CHECK(never(pushed_down.impact(2)));
  CHECK(pushed_down.at(2.5).y == Approx(2));

  const BouncingBall clay = ball_dropped_from_one_metre(1, 0);
  CHECK(clay.rest_time() == clay.impact(1).time);
  CHECK(never(clay.impact(2)));
  CHECK(clay.at(0.6).v == 0);
}

TEST_CASE("a bouncing ball out of the physical range is refused", "[references]") {
  CHECK_THROWS_AS((BouncingBall{-1, 0, 9.81, 1, 0.8}.at(0)), std::invalid_argument);
  CHECK_THROWS_AS((BouncingBall{1, infinity, 9.81, 1, 0.8}.at(0)), std::invalid_argument);
  CHECK_THROWS_AS((BouncingBall{1, 0, -9.81, 1, 0.8}.at(0)), std::invalid_argument);
  CHECK_THROWS_AS((BouncingBall{1, 0, 9.81, 0, 0.8}.at(0)), std::invalid_argument);
  CHECK_THROWS_AS((BouncingBall{1, 0, 9.81, 1, std::nan("")}.rest_time()), std::invalid_argument);
  CHECK_THROWS_AS(ball_dropped_from_one_metre(1).at(-1), std::invalid_argument);
  CHECK_THROWS_AS(ball_dropped_from_one_metre(1).impact(0), std::invalid_argument);
  CHECK_THROWS_WITH((BouncingBall{1, 0, 9.81, 1, 1.5}.at(0)),
                    "BouncingBall: restitution is 1.5, it must be from 0 to 1");
}

TEST_CASE("two discs that meet on a spring keep their momentum and energy and swap their relative speed",
          "[references]") {
  const SpringPair pair = unequal_pair();
  const SpringPair::State start = pair.at(0);
  const double end = pair.contact_end();
  for (double t = 0; t < 2 * end; t += end / 100) {
    CAPTURE(t);
    CHECK(momentum(pair, pair.at(t)) == Approx(momentum(pair, start)).margin(16 * round_off));
    CHECK(energy(pair, pair.at(t)) == Approx(energy(pair, start)).epsilon(1e-13));
  }
  const SpringPair::State parted = pair.at(2 * end);
  CHECK(parted.v2 - parted.v1 == Approx(start.v1 - start.v2).epsilon(8 * round_off));
  CHECK(parted.x2 - parted.x1 == Approx(0.2 + 0.9 * end).epsilon(8 * round_off));
}

TEST_CASE("the contact of two discs lasts half a period of their spring", "[references]") {
  const SpringPair pair = unequal_pair();
  const double w = std::sqrt(1000 / 0.75);  // reduced mass 1 x 3 / (1 + 3)
  CHECK(pair.angular_frequency() == Approx(w).epsilon(4 * round_off));
  CHECK(pair.contact_begin() == Approx(0.7 / 0.9).epsilon(4 * round_off));
  CHECK(pair.contact_end() - pair.contact_begin() == Approx(3.14159265358979324 / w).epsilon(1e-14));
  CHECK(pair.max_overlap() == Approx(0.9 / w).epsilon(4 * round_off));
  const SpringPair::State deepest = pair.at((pair.contact_begin() + pair.contact_end()) / 2);
  CHECK(0.2 - (deepest.x2 - deepest.x1) == Approx(pair.max_overlap()).epsilon(1e-13));
  CHECK(deepest.v1 == Approx(deepest.v2).epsilon(1e-13));
}

TEST_CASE("positions and speeds of two discs do not jump where contact begins and ends", "[references]") {
  const SpringPair pair = unequal_pair();
  for (const double t : {pair.contact_begin(), pair.contact_end()}) {
    // dt leaves 2 dt v = 2e-12 in x and, since the force is still small, 2 w^2 V dt^2 plus round-off in v.
    const double dt = 1e-12;
    const SpringPair::State before = pair.at(t - dt), after = pair.at(t + dt);
    CHECK(std::abs(after.x1 - before.x1) < 3e-12);
    CHECK(std::abs(after.x2 - before.x2) < 3e-12);
    CHECK(std::abs(after.v1 - before.v1) < 1e-14);
    CHECK(std::abs(after.v2 - before.v2) < 1e-14);
    const SpringPair::State touching = pair.at(t);
    CHECK(touching.x2 - touching.x1 == Approx(0.2).epsilon(1e-14));
  }
}

TEST_CASE("two discs obey Newton's law of their spring, in either order on the axis", "[references]") {
  SpringPair pair = unequal_pair();
  if (GENERATE(false, true)) {
    std::swap(pair.x1, pair.x2);
    std::swap(pair.v1, pair.v2);
  }
  const double dt = 1e-6;  // dt^2 w^2/6 of an acceleration of 30: 7e-9; round-off 1e-16/dt = 1e-10
  const double duration = pair.contact_end() - pair.contact_begin();
  for (double part = -0.95; part < 2; part += 0.1) {  // before, during and after the contact
    const double t = pair.contact_begin() + part * duration;
    const SpringPair::State now = pair.at(t);
    const double distance = std::abs(now.x2 - now.x1);
    const double push = pair.stiffness * std::fmax(0.2 - distance, 0.0) * (now.x1 > now.x2 ? 1 : -1);
    CHECK(std::abs((pair.at(t + dt).v1 - pair.at(t - dt).v1) / (2 * dt) - push / pair.mass1) < 3e-8);
    CHECK(std::abs((pair.at(t + dt).x1 - pair.at(t - dt).x1) / (2 * dt) - now.v1) < 3e-8);
    CHECK(std::abs((pair.at(t + dt).v2 - pair.at(t - dt).v2) / (2 * dt) + push / pair.mass2) < 3e-8);
  }
}

TEST_CASE("discs that move apart never meet, and discs that would pass through each other are refused",
          "[references]") {
  SpringPair pair = unequal_pair();
  pair.v1 = -1;
  CHECK(pair.contact_begin() == infinity);
  CHECK(pair.max_overlap() == 0);
  CHECK(pair.at(10).x1 == Approx(-10.5));
  pair.v1 = 8;  // V/w = 0.22 > 2h
  CHECK_THROWS_AS(pair.at(0), std::invalid_argument);
  pair = unequal_pair();
  pair.x2 = pair.x1 + 0.19;
  CHECK_THROWS_AS(pair.at(0), std::invalid_argument);
  pair = unequal_pair();
  pair.mass2 = 0;
  CHECK_THROWS_AS(pair.at(0), std::invalid_argument);
}

TEST_CASE("explicit Euler throws two discs apart faster than they met", "[references]") {
  CHECK(explicit_euler_amplification(0.1) == Approx(1.01));
  // Measured on single contacts. The contact ends within a step, whose amplification is the tolerance.
  const std::vector<std::pair<double, double>> measured{
      {0.5, 2.13}, {0.2, 1.366}, {0.1, 1.170}, {0.05, 1.082}, {0.025, 1.040}};
  for (const auto& [w_dt, restitution] : measured) {
    CHECK(explicit_euler_restitution(w_dt) == Approx(restitution).epsilon(w_dt * w_dt / 2 + 5e-4));
  }
}

TEST_CASE("every disc of a column at rest carries the weight of those above it", "[references]") {
  const double mass = 2, gravity = 9.81, stiffness = 1e5, radius = 0.01;
  const int count = 25;
  const RestingStack stack = resting_stack(count, mass, gravity, stiffness, radius);
  REQUIRE(stack.heights.size() == 25);
  REQUIRE(stack.overlaps.size() == 24);
  CHECK(stack.heights.front() == radius);
  CHECK(stack.floor_force == Approx(count * mass * gravity));
  CHECK(stack.overlaps.back() == Approx(mass * gravity / stiffness));
  double from_below = stack.floor_force;
  for (std::size_t i = 0; i < stack.heights.size(); ++i) {
    const bool top = i + 1 == stack.heights.size();
    const double overlap = top ? 0 : 2 * radius - (stack.heights[i + 1] - stack.heights[i]);
    if (!top) CHECK(overlap == Approx(stack.overlaps[i]).epsilon(1e-10));
    // Heights of 0.4 m in doubles, times k: 1e5 x 2e-16 each.
    CHECK(std::abs(from_below - stiffness * overlap - mass * gravity) < 1e-9);
    from_below = stiffness * overlap;
  }
}

TEST_CASE("a column that its springs cannot carry is refused", "[references]") {
  CHECK(resting_stack(1, 1, 9.81, 100, 0.1).overlaps.empty());
  CHECK(resting_stack(3, 1, 0, 100, 0.1).heights.back() == Approx(0.5));  // weightless: they just touch
  CHECK_THROWS_AS(resting_stack(4, 1, 9.81, 100, 0.1), std::invalid_argument);
  CHECK_THROWS_AS(resting_stack(0, 1, 9.81, 100, 0.1), std::invalid_argument);
  CHECK_THROWS_AS(resting_stack(2, 1, 9.81, infinity, 0.1), std::invalid_argument);
}
