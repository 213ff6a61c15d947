#include "stage4_sph/references.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>

#include "common/references/dam_break_front.hpp"
#include "common/references/elliptical_drop.hpp"
#include "common/references/hydrostatic.hpp"
#include "common/simulation/errors.hpp"
#include "common/words.hpp"
#include "stage4_sph/parameters.hpp"

namespace clapotis::stage4 {

Measure front(double spacing) {
  return {.name = "front_x", .unit = "L", .value = [=](const System& s) {
            return s.particles.size() > 0 ? s.position.col(0).maxCoeff() + spacing / 2 : 0;
          }};
}

Reference dam_break_experiment(const Measure& front, double a, double gravity) {
  std::vector<std::string> names;
  for (const auto& experiment : dam_break_fronts) names.emplace_back(experiment.name);
  return {.name = std::string(koshizuka_oka_1996.name),
          .measure = "|front - experiment|/a",
          .unit = "",
          .source = std::string(koshizuka_oka_1996.source),
          .error =
              [=](const System& s) {
                return std::abs(front.value(s) / a -
                                koshizuka_oka_1996.front(s.time * std::sqrt(2 * gravity / a)));
              },
          .positions =
              [=](double t) {
                Vectors fronts = Vectors::Zero(std::ssize(dam_break_fronts), 2);
                for (Index k = 0; k < fronts.rows(); ++k)
                  fronts(k, 0) =
                      a * dam_break_fronts[static_cast<std::size_t>(k)].front(t * std::sqrt(2 * gravity / a));
                return fronts;
              },
          .shape = Shape::marks,
          .labels = names};
}

Reference hydrostatic_pressure(const HydrostaticColumn& exact, double height, double width) {
  const double surface = exact.compressed(height);
  return {.name = "hydrostatic pressure",
          .measure = "L2(p - p_exact)/L2(p_exact)",
          .unit = "",
          .source = "balance of weight and pressure of a liquid with the Cole equation",
          .error =
              [=](const System& s) {
                double wrong = 0, right = 0;
                for (Index i = 0; i < s.particles.size(); ++i) {
                  const double p = exact.pressure(surface - s.position(i, 1));
                  wrong += (s.particles.pressure(i) - p) * (s.particles.pressure(i) - p);
                  right += p * p;
                }
                return std::sqrt(wrong / right);
              },
          .positions =
              [=](double /*t*/) {
                Vectors level(2, 2);
                level << 0, surface, width, surface;
                return level;
              },
          .shape = Shape::lines};
}

std::vector<Measure> stretches(const Vectors& start) {
  const auto outermost = [](const Vectors& r) { return r.col(1).abs().maxCoeff(); };
  const auto moment = [](const Vectors& r) { return std::sqrt(r.col(1).square().mean()); };
  return {{.name = "stretch_outermost",
           .unit = "1",
           .value = [=, first = outermost(start)](const System& s) { return outermost(s.position) / first; }},
          {.name = "stretch_moment", .unit = "1", .value = [=, first = moment(start)](const System& s) {
             return moment(s.position) / first;
           }}};
}

Measure centre_pressure() {
  return {.name = "centre_pressure", .unit = "kg/(L s^2)", .value = [](const System& s) {
            std::array<std::pair<double, double>, 4> nearest;
            nearest.fill({std::numeric_limits<double>::infinity(), 0});
            for (Index i = 0; i < s.particles.size(); ++i) {
              const std::pair candidate{dot(row(s.position, i), row(s.position, i)), s.particles.pressure(i)};
              const auto farthest = std::max_element(nearest.begin(), nearest.end());
              if (candidate < *farthest) *farthest = candidate;
            }
            double sum = 0;
            for (const auto& [distance, pressure] : nearest) sum += pressure;
            return sum / 4;
          }};
}

Reference ellipse(const std::vector<Measure>& stretches, const EllipticalDrop& exact) {
  return {.name = "exact ellipse",
          .measure = "|b - b_exact|/b_exact",
          .unit = "",
          .source = "Monaghan 1994, J. Comput. Phys. 110: 399-406",
          .error =
              [=, stretch = stretches.front()](const System& s) {
                return std::abs(stretch.value(s) / (exact.at(s.time).semi_axis_y / exact.radius) - 1);
              },
          .positions =
              [=](double t) {
                constexpr Index points = 180;
                const auto shape = exact.at(t);
                Vectors outline(points, 2);
                for (Index k = 0; k < points; ++k) {
                  const double angle = 2 * std::numbers::pi * static_cast<double>(k) / points;
                  outline.row(k) << shape.semi_axis_x * std::cos(angle), shape.semi_axis_y * std::sin(angle);
                }
                return outline;
              },
          .shape = Shape::outline};
}

void require_inside_tank(Parameters& p, const Tank& tank, const std::vector<Parameter>& sides) {
  for (const auto& side : sides) {
    const bool across = side.symbol == "a";
    const double most = across ? tank.width : tank.height, value = p.number(side);
    if (value > most)
      throw BadInput(say(words().outside_box, fmt::arg("name", side.name), fmt::arg("value", to_text(value)),
                         fmt::arg("low", "0"), fmt::arg("high", to_text(most)),
                         fmt::arg("unit", p.length_unit())));
  }
}

}  // namespace clapotis::stage4
