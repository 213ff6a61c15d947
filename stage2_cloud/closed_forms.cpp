#include "stage2_cloud/closed_forms.hpp"

#include <cmath>
#include <limits>

#include "common/references/spring_pair.hpp"
#include "common/references/stack.hpp"
#include "common/simulation/errors.hpp"
#include "common/words.hpp"

namespace clapotis::stage2 {
namespace {

constexpr double not_a_number = std::numeric_limits<double>::quiet_NaN();

}  // namespace

std::optional<Reference> head_on_collision(const Parameters& p, const Particles& particles,
                                           const Walls& walls) {
  const auto& r = particles.position;
  const auto& v = particles.velocity;
  const double h = p.value("radius");
  if (p.value("gravity") != 0 || p.value("drag") != 0 || std::abs(r(0, 0) - r(1, 0)) < 2 * h)
    return std::nullopt;
  const SpringPair exact{.stiffness = p.value("stiffness"),
                         .radius = h,
                         .mass1 = particles.mass(0),
                         .mass2 = particles.mass(1),
                         .x1 = r(0, 0),
                         .x2 = r(1, 0),
                         .v1 = v(0, 0),
                         .v2 = v(1, 0)};
  const double w = std::sqrt(exact.stiffness / exact.mass1 + exact.stiffness / exact.mass2);
  if ((exact.v1 - exact.v2) * (exact.x2 > exact.x1 ? 1 : -1) >= 2 * h * w) return std::nullopt;
  const double y = r(0, 1), vy = v(0, 1);
  const auto inside = [walls](double x, double height) {
    return x >= walls.left && x <= walls.right && height >= walls.bottom && height <= walls.top;
  };
  return Reference{.name = "closed form",
                   .measure = "max |x - x_exact|",
                   .unit = p.length_unit(),
                   .source = "linear spring between two discs: half a period, pi sqrt(mu/k), of contact",
                   .error =
                       [=](const System& s) {
                         const auto at = exact.at(s.time);
                         if (!inside(at.x1, y + vy * s.time) || !inside(at.x2, y + vy * s.time))
                           return not_a_number;
                         return std::max(std::abs(s.position(0, 0) - at.x1),
                                         std::abs(s.position(1, 0) - at.x2));
                       },
                   .positions =
                       [=](double t) {
                         const auto at = exact.at(t);
                         if (!inside(at.x1, y + vy * t) || !inside(at.x2, y + vy * t)) return Vectors(0, 2);
                         Vectors places(2, 2);
                         places << at.x1, y + vy * t, at.x2, y + vy * t;
                         return places;
                       }};
}

std::optional<Reference> column_at_rest(const Parameters& p, Index n) {
  const double weight_on_lowest = static_cast<double>(n - 1) * p.value("mass") * p.value("gravity");
  if (weight_on_lowest >= 2 * p.value("radius") * p.value("stiffness")) return std::nullopt;
  const auto rest = resting_stack(static_cast<int>(n), p.value("mass"), p.value("gravity"),
                                  p.value("stiffness"), p.value("radius"));
  const Column heights = Eigen::Map<const Column>(rest.heights.data(), n);
  const double x = p.value("width") / 2;
  return Reference{
      .name = "closed form",
      .measure = "max |y - y_rest|",
      .unit = p.length_unit(),
      .source = "balance of weight and contact forces: the n-th contact from the top overlaps by n m g/k",
      .error = [heights](const System& s) { return (s.position.col(1) - heights).abs().maxCoeff(); },
      .positions =
          [heights, x](double /*t*/) {
            Vectors places(heights.size(), 2);
            places.col(0) = x;
            places.col(1) = heights;
            return places;
          }};
}

void require_height(const Parameters& p, Index n, double radius) {
  const double most = std::floor(p.value("height") / (2 * radius));
  if (static_cast<double>(n) > most)
    throw BadInput(say(words().too_many_discs, fmt::arg("count", n), fmt::arg("radius", to_text(radius)),
                       fmt::arg("unit", p.length_unit()), fmt::arg("most", most)));
}

}  // namespace clapotis::stage2
