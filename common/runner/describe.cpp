#include "common/runner/describe.hpp"

#include <algorithm>
#include <cmath>

#include "common/laws/dummy_walls.hpp"
#include "common/runner/describe_inside.hpp"
#include "common/runner/ticks.hpp"
#include "common/runner/units.hpp"
#include "common/simulation/errors.hpp"
#include "common/words.hpp"

namespace clapotis {
namespace {

Eigen::ArrayXd forces(Simulation& simulation) {
  Eigen::ArrayXd force;
  simulation.look([&](const System& system) {
    const auto& p = system.particles;
    force = p.acceleration.square().rowwise().sum().sqrt();
    for (Index i = 0; i < p.size(); ++i) force(i) *= p.mass(i);
  });
  return force;
}

/// Which values the colours span.
enum class Span { from_zero, around_zero, all };

/// What the particles are coloured by; no values: plain.
struct Quantity {
  std::string label, unit;
  Eigen::ArrayXd values;
  Span span = Span::from_zero;
};

Quantity quantity(Simulation& simulation, const std::string& name) {
  const auto& particles = simulation.particles();
  const auto& length = simulation.scene().length_unit;
  const auto& fluid = simulation.setup().fluid;
  if (name == "speed") return {"|v|", length + "/s", particles.velocity.square().rowwise().sum().sqrt()};
  if (name == "force") return {"|m a|", printed(short_force_unit(simulation)), forces(simulation)};
  if (name == "vorticity" && fluid)
    return {"ω", "1/s", simulation.model().vorticity(particles), Span::around_zero};
  if (name == "density_error" && fluid)
    return {"ρ/ρ₀ − 1", "%", 100 * (particles.density / fluid->state.reference_density - 1),
            Span::around_zero};
  for (const auto& column : particles.columns()) {
    if (column.name != name) continue;
    const bool has_sign = name == "density" || (name == "pressure" && fluid && fluid->state.tension);
    return {symbol(name), printed(short_unit(column.unit, length)), column.values,
            has_sign ? Span::all : Span::from_zero};
  }
  return {};
}

/// Without the outermost half per cent at either end: one splash must not take all colours for itself.
std::pair<double, double> bulk(const Eigen::ArrayXd& values) {
  std::vector<double> finite;
  for (const double value : values)
    if (std::isfinite(value)) finite.push_back(value);
  if (finite.empty()) return {0, 0};
  const auto outside = static_cast<std::ptrdiff_t>(finite.size() / 200);
  const auto least = finite.begin() + outside, greatest = finite.end() - 1 - outside;
  std::nth_element(finite.begin(), least, finite.end());
  const double lo = *least;
  std::nth_element(finite.begin(), greatest, finite.end());
  return {lo, *greatest};
}

std::pair<double, double> range_of(const Quantity& quantity) {
  const auto [lo, hi] = bulk(quantity.values);
  if (quantity.span == Span::all) return {lo, hi};
  const double reach = quantity.span == Span::around_zero ? std::max(-lo, hi) : hi;
  if (quantity.span == Span::around_zero) return {-reach, reach};
  return {0, reach > 0 ? reach : 1};
}

void colour(Picture& picture, Simulation& simulation, const Viewpoint& viewpoint) {
  auto shown = quantity(simulation, viewpoint.colour_by);
  if (shown.values.size() == 0) return;
  std::tie(picture.colours.lo, picture.colours.hi) = viewpoint.range.value_or(range_of(shown));
  picture.colours.map = shown.span == Span::around_zero ? ColourMap::cool_warm : ColourMap::viridis;
  picture.colours.label = std::move(shown.label);
  picture.colours.unit = std::move(shown.unit);
  picture.value = std::move(shown.values);
}

/// The particles of walls that stand inside the picture: plates, floors with a slot, drawn obstacles.
void add_solids(Picture& picture, const Simulation& simulation) {
  const auto* walls = simulation.model().wall_particles();
  if (walls == nullptr) return;
  const auto& view = simulation.setup().view;
  std::vector<Vector> seen;
  for (Index k = 0; k < walls->size(); ++k) {
    const Vector r = row(walls->places, k);
    if (view.contains(r)) seen.push_back(r);
  }
  picture.solid_x.resize(static_cast<Index>(seen.size()));
  picture.solid_y.resize(static_cast<Index>(seen.size()));
  for (std::size_t k = 0; k < seen.size(); ++k) {
    picture.solid_x(static_cast<Index>(k)) = seen[k].x;
    picture.solid_y(static_cast<Index>(k)) = seen[k].y;
  }
}

void add_ghosts(Picture& picture, const Simulation& simulation) {
  const auto& reference = simulation.setup().reference;
  if (!reference || !reference->positions) return;
  const Vectors positions = reference->positions(simulation.time());
  if (positions.rows() == 0 || positions.isNaN().all()) return;
  Ghosts ghosts{positions.col(0), positions.col(1), std::string(called(reference->name)), reference->shape,
                reference->labels};
  if (reference->measured) {
    const Vectors measured = reference->measured(simulation.system());
    ghosts.measured_x = measured.col(0);
    ghosts.measured_y = measured.col(1);
    ghosts.measured_label = std::string(words().measured_points);
  }
  picture.ghosts = std::move(ghosts);
}

void add_grid(Picture& picture, Simulation& simulation) {
  if (simulation.particles().size() == 0) return;
  const auto around = simulation.model().neighbourhood(simulation.particles(), 0);
  if (around && around->cell.y > 0) picture.cell = around->cell.y;
}

std::string error_note(const Simulation& simulation) {
  const auto& reference = simulation.setup().reference;
  const double error = simulation.error();
  if (!reference || !std::isfinite(error)) return {};
  const auto measure = std::string(called(reference->measure)), unit = reference->unit;
  const auto what = reference->shape == Shape::marks  // of several
                        ? fmt::format("{}: {}", called(reference->name), measure)
                        : measure;
  if (unit.empty() && error >= 1e-4) return fmt::format("{} = {:.2f} %", what, 100 * error);
  const bool plain = error >= 1e-3 && error < 1e3;
  const auto number = plain ? fmt::format("{:.3g}", error) : fmt::format("{:.2e}", error);
  return fmt::format("{} = {}{}", what, number, unit.empty() ? "" : " " + unit);
}

}  // namespace

std::vector<std::string> colourings(const Simulation& simulation) {
  std::vector<std::string> names{"speed"};
  const auto& particles = simulation.particles();
  if (simulation.setup().fluid)
    names.insert(names.end(), {"pressure", "vorticity", "density_error", "density"});
  names.emplace_back("force");
  for (const auto& column : particles.columns())
    if (std::find(names.begin(), names.end(), column.name) == names.end()) names.emplace_back(column.name);
  names.emplace_back("plain");
  return names;
}

std::string colouring(const Simulation& simulation, const std::optional<std::string>& wanted) {
  if (!wanted) return simulation.setup().colour_by;
  const auto known = colourings(simulation);
  if (std::find(known.begin(), known.end(), *wanted) == known.end())
    throw BadInput(unknown_name("quantity", *wanted, known));
  return *wanted;
}

std::string symbol(std::string_view column) {
  if (column == "density") return "ρ";
  if (column == "pressure") return "p";
  return std::string(column);
}

std::string step_text(const Simulation& simulation) {
  const bool given = std::isfinite(simulation.parameters().value("dt"));
  return simulation.model().limits_follow_state() && !given ? three_digits(simulation.dt())
                                                            : fmt::format("{:.3g}", simulation.dt());
}

Picture describe(const std::string& stage_title, Simulation& simulation, const Viewpoint& viewpoint) {
  const auto& particles = simulation.particles();
  const auto& view = simulation.setup().view;
  Picture picture;
  picture.title = std::string(called(stage_title)) + " - " + simulation.scene().name;
  picture.subtitle = fmt::format("t = {:.3f} s   dt = {} s   N = {}   {}", simulation.time(),
                                 step_text(simulation), particles.size(), simulation.integrator());
  picture.lower = {view.left, view.bottom};
  picture.upper = {view.right, view.top};
  picture.length_unit = simulation.scene().length_unit;
  if (const auto walls = simulation.model().walls())
    picture.walls = {std::isfinite(walls->left), std::isfinite(walls->right), std::isfinite(walls->bottom),
                     std::isfinite(walls->top)};
  picture.x = particles.position.col(0);
  picture.y = particles.position.col(1);
  picture.radius = simulation.setup().radius;
  picture.liquid = simulation.setup().fluid.has_value();
  add_solids(picture, simulation);
  colour(picture, simulation, viewpoint);
  if (viewpoint.ghosts) add_ghosts(picture, simulation);
  if (viewpoint.grid) add_grid(picture, simulation);
  const auto chosen = viewpoint.chosen ? particles.place_of(*viewpoint.chosen) : std::nullopt;
  if (chosen) picture.chosen = look_inside(simulation, *chosen, viewpoint.kernel);
  picture.note = error_note(simulation);
  return picture;
}

}  // namespace clapotis
