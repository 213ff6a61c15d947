#include "common/laws/walls.hpp"

#include <algorithm>
#include <cmath>

#include "common/simulation/errors.hpp"
#include "common/simulation/model.hpp"
#include "common/simulation/parallel.hpp"
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

double clamp_axis(double low, double high, double e, double dt, double& r, double& v, long long& folded) {
  if (!(r < low || r > high)) return 0;  // a NaN stays one, to be found
  const bool below = r < low;
  const double reach = below ? low - r : r - high;
  const double before = v;
  if (reach > high - low) {
    const double start = std::clamp(r - v * dt, low, high);
    const auto end = fold(start, (r - start) / dt, dt, low, high, e);
    const double flights = std::pow(e, end.impacts);
    r = end.position;
    v = std::copysign(std::abs(v) * flights, end.velocity);
    ++folded;
  } else {
    r = below ? low : high;
    if (below ? v < 0 : v > 0) v = -e * v;
  }
  return (before * before - v * v) / 2;
}

void settle_all(const Walls& walls, System& s, double dt) {
  std::vector<long long> folded(blocks_of(s.position.rows()), 0);
  s.dissipated_energy += sum_over(s.position.rows(), s.model.threads, [&](Index i, std::size_t block) {
    Vector r = row(s.position, i), v = row(s.velocity, i);
    if (r.x >= walls.left && r.x <= walls.right && r.y >= walls.bottom && r.y <= walls.top) return 0.0;
    const double lost = s.particles.mass(i) * walls.clamp(r, v, dt, folded[block]);
    s.position.row(i) << r.x, r.y;
    s.velocity.row(i) << v.x, v.y;
    return lost;
  });
  for (const auto count : folded) s.model.folded += count;
}

}  // namespace

double Walls::clamp(Vector& r, Vector& v, double dt, long long& folded) const {
  return clamp_axis(left, right, restitution, dt, r.x, v.x, folded) +
         clamp_axis(bottom, top, restitution, dt, r.y, v.y, folded);
}

void require_inside(Parameters& p, const Walls& walls) {
  const auto check = [&](const Parameter& parameter, double low, double high) {
    const double value = p.number(parameter);
    if (value >= low && value <= high) return;
    throw BadInput(say(words().outside_box, fmt::arg("name", parameter.name),
                       fmt::arg("value", to_text(value)), fmt::arg("low", to_text(low)),
                       fmt::arg("high", to_text(high)), fmt::arg("unit", p.length_unit())));
  };
  check(start_x, walls.left, walls.right);
  check(start_y, walls.bottom, walls.top);
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

void BoxWalls::settle(System& system, double dt) const { settle_all(walls, system, dt); }

CentreFloor CentreFloor::from(Parameters& p) {
  constexpr double infinite = std::numeric_limits<double>::infinity();
  return {{.left = 0,
           .right = p.number(box_width),
           .bottom = 0,
           .top = infinite,
           .restitution = p.number(restitution)}};
}

void CentreFloor::settle(System& system, double dt) const { settle_all(walls, system, dt); }

}  // namespace clapotis
