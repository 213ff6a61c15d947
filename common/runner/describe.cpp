#include "common/runner/describe.hpp"

#include <cmath>

#include "common/runner/series.hpp"
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

/// Fills `value` and `colours`; both stay empty for plain discs.
void colour(Picture& picture, Simulation& simulation, const Viewpoint& viewpoint) {
  const auto& particles = simulation.particles();
  const auto& length = simulation.scene().length_unit;
  if (viewpoint.colour_by == "speed") {
    picture.value = particles.velocity.square().rowwise().sum().sqrt();
    picture.colours.label = "|v|";
    picture.colours.unit = length + "/s";
  } else if (viewpoint.colour_by == "force") {
    picture.value = forces(simulation);
    picture.colours.label = "|m a|";
    picture.colours.unit = length == "m" ? "N" : with_length("kg L/s²", length);
  } else {
    for (const auto& column : particles.columns()) {
      if (column.name != viewpoint.colour_by) continue;
      picture.value = column.values;
      picture.colours.label = column.name;
      picture.colours.unit = with_length(column.unit, length);
    }
  }
  if (picture.value.size() == 0) return;
  const double greatest = picture.value.isFinite().select(picture.value, 0.0).maxCoeff();
  std::tie(picture.colours.lo, picture.colours.hi) =
      viewpoint.range.value_or(std::pair{0.0, greatest > 0 ? greatest : 1.0});
}

void add_ghosts(Picture& picture, const Simulation& simulation) {
  const auto& reference = simulation.setup().reference;
  if (!reference || !reference->positions) return;
  const Vectors positions = reference->positions(simulation.time());
  if (positions.rows() == 0 || !positions.allFinite()) return;
  picture.ghosts = Ghosts{positions.col(0), positions.col(1), reference->name};
}

void add_neighbours(Picture& picture, Simulation& simulation, const Viewpoint& viewpoint) {
  const Index particle = viewpoint.chosen.value_or(0);
  if ((!viewpoint.grid && !viewpoint.chosen) || particle >= simulation.particles().size()) return;
  const auto around = simulation.model().neighbourhood(simulation.particles(), particle);
  if (!around) return;
  if (viewpoint.grid && around->cell.y > 0) picture.cell = around->cell.y;
  if (!viewpoint.chosen) return;
  picture.chosen = Chosen{
      particle, around->neighbours, around->support,
      say(words().chosen_particle, fmt::arg("id", particle), fmt::arg("count", around->neighbours.size()))};
}

std::string error_note(const Simulation& simulation) {
  const auto& reference = simulation.setup().reference;
  const double error = simulation.error();
  if (!reference || !std::isfinite(error)) return {};
  return fmt::format("{} = {:.2e} {}", reference->measure, error, reference->unit);
}

}  // namespace

std::vector<std::string> colourings(const Simulation& simulation) {
  std::vector<std::string> names{"speed", "force"};
  for (const auto& column : simulation.particles().columns()) names.emplace_back(column.name);
  names.emplace_back("plain");
  return names;
}

Picture describe(const std::string& stage_title, Simulation& simulation, const Viewpoint& viewpoint) {
  const auto& particles = simulation.particles();
  const auto& view = simulation.setup().view;
  Picture picture;
  picture.title = stage_title + " - " + simulation.scene().name;
  picture.subtitle = fmt::format("t = {:.3f} s   dt = {:.3g} s   N = {}   {}", simulation.time(),
                                 simulation.dt(), particles.size(), simulation.integrator());
  picture.lower = {view.left, view.bottom};
  picture.upper = {view.right, view.top};
  picture.length_unit = simulation.scene().length_unit;
  if (const auto walls = simulation.model().walls())
    picture.walls = {std::isfinite(walls->left), std::isfinite(walls->right), std::isfinite(walls->bottom),
                     std::isfinite(walls->top)};
  picture.x = particles.position.col(0);
  picture.y = particles.position.col(1);
  picture.radius = simulation.setup().radius;
  colour(picture, simulation, viewpoint);
  if (viewpoint.ghosts) add_ghosts(picture, simulation);
  add_neighbours(picture, simulation, viewpoint);
  picture.note = error_note(simulation);
  return picture;
}

}  // namespace clapotis
