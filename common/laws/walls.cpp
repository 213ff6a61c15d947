#include "common/laws/walls.hpp"

#include <algorithm>
#include <cmath>

#include "common/particles/parallel.hpp"
#include "common/simulation/errors.hpp"
#include "common/simulation/model.hpp"
#include "common/simulation/system.hpp"
#include "common/words.hpp"

namespace clapotis {
namespace {

const Parameter restitution{
    .name = "restitution", .symbol = "e", .unit = "", .value = 0.8, .range = {.low = 0, .high = 1}};

void require_room(double h, double side, const std::string& unit) {
  if (2 * h >= side)
    throw BadInput(say(words().box_too_small, fmt::arg("radius", to_text(h)), fmt::arg("side", to_text(side)),
                       fmt::arg("unit", unit)));
}

/// Normal coordinate and velocity of one particle, and the acceleration that its speed at the wall is
/// computed with.
struct Normal {
  double r, v, a;
};

/// Energy per unit of mass that the impact takes.
double clamp_axis(double low, double high, double e, double dt, Normal& n, long long& folded) {
  if (!(n.r < low || n.r > high)) return 0;  // a NaN stays one, to be found
  const bool below = n.r < low;
  const double depth = below ? low - n.r : n.r - high;
  if (depth > high - low) {
    const double before = n.v, start = std::clamp(n.r - n.v * dt, low, high);
    const auto end = fold(start, (n.r - start) / dt, dt, low, high, e);
    n.r = end.position;
    n.v = std::copysign(std::abs(n.v) * std::pow(e, end.impacts), end.velocity);
    ++folded;
    return (before * before - n.v * n.v) / 2;
  }
  n.r = below ? low : high;
  const double inward = below ? -n.v : n.v, pressing = below ? -n.a : n.a;
  if (inward <= 0) return 0;
  const double at_wall2 = std::max(inward * inward - 2 * pressing * depth, 0.0);
  n.v = (below ? e : -e) * std::sqrt(at_wall2);
  return (1 - e * e) * at_wall2 / 2;
}

/// Brings all particles back between the walls. `pressing(i)` is the acceleration that counts for the speed
/// at the wall.
template <class Pressing>
void settle_all(const Walls& walls, System& s, double dt, const Pressing& pressing) {
  const Index n = s.position.rows();
  std::vector<long long> folded(blocks_of(n), 0);
  s.dissipated_energy +=
      sum_over(n, threads_for_little(n, s.particles.threads), [&](Index i, std::size_t block) {
        Vector r = row(s.position, i), v = row(s.velocity, i);
        if (r.x >= walls.left && r.x <= walls.right && r.y >= walls.bottom && r.y <= walls.top) return 0.0;
        const double lost = s.particles.mass(i) * walls.clamp(r, v, pressing(i), dt, folded[block]);
        s.position.row(i) << r.x, r.y;
        s.velocity.row(i) << v.x, v.y;
        return lost;
      });
  for (const auto count : folded) s.model.folded += count;
}

constexpr auto not_counted = [](Index /*i*/) { return Vector{0, 0}; };

}  // namespace

double Walls::clamp(Vector& r, Vector& v, const Vector& a, double dt, long long& folded) const {
  Normal x{r.x, v.x, a.x}, y{r.y, v.y, a.y};
  const double lost = clamp_axis(left, right, restitution, dt, x, folded) +
                      clamp_axis(bottom, top, restitution, dt, y, folded);
  r = {x.r, y.r};
  v = {x.v, y.v};
  return lost;
}

void require_inside(Parameters& p, const Walls& walls, double margin) {
  const auto check = [&](const Parameter& parameter, double low, double high) {
    const double value = p.number(parameter);
    if (value >= low && value <= high) return;
    throw BadInput(say(words().outside_box, fmt::arg("name", parameter.name),
                       fmt::arg("value", to_text(value)), fmt::arg("low", to_text(low)),
                       fmt::arg("high", to_text(high)), fmt::arg("unit", p.length_unit())));
  };
  check(start_x, walls.left - margin, walls.right - margin);
  check(start_y, walls.bottom - margin, walls.top - margin);
}

Folded fold(double start, double v, double dt, double low, double high, double e) {
  const double speed = std::abs(v), length = high - low;
  const double first = (v > 0 ? high - start : start - low) / speed;  // time of the first impact
  if (speed == 0 || !(first < dt)) return {start + v * dt, v, 0};
  const double crossings = (dt - first) * speed / length;  // what is left, in boxes at full speed
  double whole = std::floor(crossings);                    // boxes crossed after the first impact
  if (e < 1) whole = e > 0 ? std::floor(std::log1p(crossings * (1 - e)) / -std::log(e)) : 0;
  // a box takes length/(speed e^k) after k impacts: the sum over k = 1..whole
  const double spent = e == 1 ? whole : std::expm1(-whole * std::log(e)) / (1 - e);
  const double impacts = whole + 1;
  const double rest = dt - first - (whole > 0 ? spent * length / speed : 0);
  const double left = std::clamp(rest * speed * std::pow(e, impacts), 0.0, length);
  const bool from_high = (v > 0) == (std::fmod(whole, 2) == 0);
  return {from_high ? high - left : low + left, (from_high ? -1 : 1) * speed * std::pow(e, impacts), impacts};
}

Folded hop(double v, double a, double dt, double e) {
  const double first = 2 * v / a;  // duration of the first hop
  const double hops = dt / first;  // that fit in dt, if none were shorter
  if (v == 0 || hops * (1 - e) >= 1) return {0, 0, std::numeric_limits<double>::infinity()};
  const double whole = std::floor(e == 1 ? hops : std::log1p(-hops * (1 - e)) / std::log(e));
  const double sum = e == 1 || whole == 0 ? whole : -std::expm1(whole * std::log(e)) / (1 - e);
  const double speed = v * std::pow(e, whole), left = std::clamp(dt - first * sum, 0.0, 2 * speed / a);
  return {left * (speed - a * left / 2), speed - a * left, whole};
}

BoxWalls BoxWalls::from(Parameters& p) {
  const double h = p.number(disc_radius), w = p.number(box_width), top = p.number(box_height);
  require_room(h, std::min(w, top), p.length_unit());
  return {{.left = h, .right = w - h, .bottom = h, .top = top - h, .restitution = p.number(restitution)}};
}

void BoxWalls::settle(System& system, double dt) const { settle_all(walls, system, dt, not_counted); }

SupportingWalls SupportingWalls::from(Parameters& p) { return {BoxWalls::from(p).walls}; }

void SupportingWalls::settle(System& system, double dt) const {
  settle_all(walls, system, dt, [&](Index i) { return row(system.acceleration, i); });
}

TankWalls TankWalls::from(Parameters& p) {
  constexpr double infinite = std::numeric_limits<double>::infinity();
  const double gap = p.value("walls") == 0 ? 0 : p.value("spacing") / 2;  // dummy, reflect
  return {{.left = gap,
           .right = p.value("tank_width") - gap,
           .bottom = gap,
           .top = infinite,
           .restitution = p.number(restitution)}};
}

void TankWalls::settle(System& system, double dt) const { settle_all(walls, system, dt, not_counted); }

CentreFloor CentreFloor::from(Parameters& p) {
  constexpr double infinite = std::numeric_limits<double>::infinity();
  return {{.left = 0,
           .right = p.number(box_width),
           .bottom = 0,
           .top = infinite,
           .restitution = p.number(restitution)}};
}

void CentreFloor::settle(System& system, double dt) const { settle_all(walls, system, dt, not_counted); }

}  // namespace clapotis
