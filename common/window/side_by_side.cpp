#include "common/window/side_by_side.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "common/integrators/bogacki_shampine.hpp"
#include "common/runner/stopwatch.hpp"
#include "common/simulation/time_step.hpp"
#include "common/window/slider_span.hpp"
#include "common/words.hpp"

namespace clapotis {
namespace {

constexpr double endless = std::numeric_limits<double>::infinity();
constexpr long steps_of_a_piece = 8;  // so far one side may be ahead: less than the eye sees

bool is_integrator(const std::string& name) { return name == "integrator"; }

bool is_rival(const Simulation& left, const std::string& name) {
  const auto& rival = left.scene().rival;
  return rival && rival->what == name;
}

/// The scene of the right side.
Scene other_scene(const Scene& scene, const std::string& contrast) {
  auto other = scene;
  if (scene.rival && scene.rival->what == contrast) other.build = scene.rival->build;
  return other;
}

/// What the user asked for of the left side, with the right side's own value. A choice may make other
/// parameters of the scene; those that it does not have then are left out.
Overrides other_overrides(const Simulation& left, const Scene& scene, const Contrast& contrast) {
  auto overrides = left.parameters().overrides();
  const auto* parameter = left.parameters().find(contrast.name);
  if (parameter == nullptr) return overrides;
  const Override own{contrast.value, Origin::window};
  if (!parameter->choices.empty()) {
    const Simulation trial(scene, {{contrast.name, own}});
    std::erase_if(overrides,
                  [&](const auto& given) { return trial.parameters().find(given.first) == nullptr; });
  }
  overrides.insert_or_assign(contrast.name, own);
  return overrides;
}

std::shared_ptr<Simulation> other_side(const Simulation& left, const Contrast& contrast) {
  const auto scene = other_scene(left.scene(), contrast.name);
  return std::make_shared<Simulation>(scene, other_overrides(left, scene, contrast),
                                      is_integrator(contrast.name) ? contrast.value : left.integrator(),
                                      left.threads());
}

/// As `./lab compare` takes it.
std::string text_of(const std::string& stage, const Simulation& simulation) {
  std::string text = stage + "/" + simulation.scene().name + ":integrator=" + simulation.integrator();
  for (const auto& [name, value] : simulation.parameters().overrides()) text += "," + name + "=" + value.text;
  return text;
}

/// Of rows: each step of a few particles; of many, for which a row costs as much as two steps, every tenth.
double interval_of(const Simulation& left, const Simulation& right) {
  constexpr Index few = 20;
  return std::max(left.dt(), right.dt()) * (left.particles().size() <= few ? 1 : 10);
}

bool is_time_step(const Parameter& p) {
  return p.name == step_parameter.name || p.name == cfl_parameter.name || p.name == tolerance_parameter.name;
}

}  // namespace

std::vector<std::string> contrasts(const Simulation& left) {
  std::vector<std::string> names{"integrator"}, steps, others;
  if (left.scene().rival) names.push_back(left.scene().rival->what);
  for (const auto& p : left.parameters().all()) {
    if (p.derived || p.list) continue;
    if (p.name == tolerance_parameter.name && !left.controls_error()) continue;
    if (!p.choices.empty()) {
      if (p.choices.size() > 1) names.push_back(p.name);
    } else {
      (is_time_step(p) ? steps : others).push_back(p.name);
    }
  }
  names.insert(names.end(), steps.begin(), steps.end());
  names.insert(names.end(), others.begin(), others.end());
  return names;
}

std::vector<std::string> contrast_values(const Simulation& left, const std::string& name) {
  if (is_integrator(name)) return integrator_names(left.setup().matter());
  if (is_rival(left, name)) return {left.scene().rival->other};
  const auto* parameter = left.parameters().find(name);
  return parameter != nullptr ? parameter->choices : std::vector<std::string>{};
}

std::string value_of(const Simulation& left, const std::string& name) {
  if (is_integrator(name)) return left.integrator();
  if (is_rival(left, name)) return left.scene().rival->own;
  const auto* parameter = left.parameters().find(name);
  return parameter != nullptr ? parameter->text() : std::string();
}

Contrast first_contrast(const Simulation& left) {
  const auto& scene = left.scene();
  if (scene.beside && value_of(left, scene.beside->first) != scene.beside->second)
    return {scene.beside->first, scene.beside->second};
  return contrast_in(left, scene.rival ? scene.rival->what : "integrator");
}

Contrast contrast_in(const Simulation& left, const std::string& name) {
  if (is_integrator(name))
    return {name, left.integrator() == "explicit_euler" ? "velocity_verlet" : "explicit_euler"};
  const auto own = value_of(left, name);
  for (const auto& value : contrast_values(left, name))
    if (value != own) return {name, value};
  const auto* p = left.parameters().find(name);
  if (p == nullptr) return {name, own};
  const double value = std::isfinite(p->value) ? p->value : left.dt();
  double other = 2 * value;
  if (value == 0) {
    const auto span = slider_span(*p, 0, left);
    other = span.low + (span.high - span.low) / 4;
  }
  if (!p->range.contains(other)) other = value / 2;
  return {name, p->integer ? fmt::format("{:.0f}", other) : fmt::format("{:.3g}", other)};
}

std::string printed_contrast(const Simulation& left, const Contrast& contrast) {
  const auto* p = left.parameters().find(contrast.name);
  if (p == nullptr || !p->choices.empty())
    return fmt::format("{} = {}", called(contrast.name), called(contrast.value));
  const auto unit = contrast.value == "auto" ? "" : printed_unit(*p, left.scene().length_unit);
  return fmt::format("{} = {}{}", printed_symbol(*p), contrast.value, unit.empty() ? "" : " " + unit);
}

SideBySide::SideBySide(const Stage& stage, std::shared_ptr<Simulation> left, Contrast contrast)
    : contrast_(std::move(contrast)),
      left_{.text = text_of(stage.name, *left), .stage_title = stage.title, .simulation = std::move(left)},
      right_{.text = {}, .stage_title = stage.title, .simulation = other_side(*left_.simulation, contrast_)},
      comparison_(left_, right_, endless, interval_of(*left_.simulation, *right_.simulation)) {
  const bool rival = is_rival(*left_.simulation, contrast_.name);
  right_.text = text_of(rival ? left_.simulation->scene().rival->stage : stage.name, *right_.simulation);
  distances_.add(comparison_);
}

Comparison::Piece SideBySide::advance_a_piece(const Comparison::Allows& allows) {
  const auto piece = comparison_.advance_a_piece(clock_, steps_of_a_piece, allows);
  if (piece == Comparison::Piece::row) distances_.add(comparison_);
  return piece;
}

bool SideBySide::advance(double duration, double budget) {
  clock_ += duration;
  const double start = wall_seconds();
  for (double now = start;; now = wall_seconds()) {
    if (now > start && now - start > budget) {
      level();
      clock_ = time();
      return false;
    }
    const auto allows = [&] { return wall_seconds() - now < budget / steps_of_a_piece; };
    if (advance_a_piece(allows) == Comparison::Piece::nothing) return true;
  }
}

void SideBySide::level() {
  if (!comparison_.steps_together()) return;
  clock_ = std::max(left_.simulation->time(), right_.simulation->time());
  while (advance_a_piece([] { return true; }) != Comparison::Piece::nothing) {
  }
}

void SideBySide::step() {
  const auto& pace = *(left_.runs() ? left_ : right_).simulation;
  clock_ = pace.time() + pace.dt();
  while (advance_a_piece([] { return true; }) != Comparison::Piece::nothing) {
  }
}

}  // namespace clapotis
