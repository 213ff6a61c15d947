#include "common/window/limit_rows.hpp"

#include <algorithm>
#include <cmath>
#include <optional>

#include "common/runner/ticks.hpp"
#include "common/window/paragraph.hpp"
#include "common/window/step_light.hpp"
#include "common/window/theme.hpp"
#include "common/words.hpp"
#include "imgui.h"

namespace clapotis {
namespace {

using Light = StepLight::Colour;

const Words::Window& w() { return words().window; }

Colour ink_of(Light light) {
  return light == Light::red ? theme::warning : light == Light::amber ? theme::caution : theme::ink;
}

Colour fill_of(Light light) {
  auto fill = light == Light::calm ? theme::accent : ink_of(light);
  fill.opacity = 0.42F;
  return fill;
}

/// With digits that do not run where the limit follows the state.
std::string seconds(double limit) {
  return limit < 0.1 ? three_digits(limit) : fmt::format("{:#.3g}", limit);
}

std::string per_cent(double share) {
  return share < 2 ? fmt::format("{:.0f} %", 100 * share) : fmt::format("x{:.2g}", share);
}

void hint(const StepLight& light, double dt) {
  if (!ImGui::IsItemHovered()) return;
  const auto& [name, formula, limit, share, stability] = light.limit;
  const auto sentence = say(w().limits.hint, fmt::arg("dt", seconds(dt)),
                            fmt::arg("share", fmt::format("{:.3g}", 100 * light.share)),
                            fmt::arg("formula", formula), fmt::arg("limit", seconds(limit)),
                            fmt::arg("kind", stability ? w().limits.stable : w().limits.accurate));
  ImGui::SetTooltip("%s", sentence.c_str());
}

/// A triangle before the limit that binds.
void mark_binding(float height) {
  const auto corner = ImGui::GetCursorScreenPos();
  const float top = corner.y + 0.2F * height, side = 0.6F * height;
  ImGui::GetWindowDrawList()->AddTriangleFilled({corner.x, top}, {corner.x, top + side},
                                                {corner.x + 0.8F * side, top + side / 2},
                                                ImGui::GetColorU32(ImGuiCol_Text));
}

/// Three columns: whose limit and its formula, its value, how much of it dt takes. A formula without room is
/// left to the hint.
void row(const StepLight& light, double dt, Controls& controls) {
  const float start = ImGui::GetCursorPosX(), whole = ImGui::GetContentRegionAvail().x;
  const float height = ImGui::GetTextLineHeight(), bar = 0.18F * whole, gap = 0.3F * height;
  const float bar_start = start + whole - bar;
  const auto value = seconds(light.limit.limit) + " s";
  const float value_start = bar_start - gap - ImGui::CalcTextSize(value.c_str()).x;
  ImGui::PushStyleColor(ImGuiCol_Text, theme::vec(ink_of(light.colour)));
  if (light.binds) mark_binding(height);
  ImGui::SetCursorPosX(start + 0.8F * height);
  {
    std::optional<theme::Bold> bold;
    if (light.binds) bold.emplace();
    text(called(light.limit.name, Naming::limit_alone));
  }
  ImGui::SameLine(0, gap);
  if (ImGui::GetCursorPosX() + ImGui::CalcTextSize(light.limit.formula.c_str()).x + gap < value_start)
    text(light.limit.formula);
  ImGui::SameLine(value_start);
  text(value);
  ImGui::SameLine(bar_start);
  ImGui::PushStyleColor(ImGuiCol_PlotHistogram, theme::vec(fill_of(light.colour)));
  ImGui::PushStyleVar(ImGuiStyleVar_FramePadding, {0, 0});
  ImGui::ProgressBar(static_cast<float>(std::min(light.share, 1.0)), {bar, height},
                     per_cent(light.share).c_str());
  ImGui::PopStyleVar();
  ImGui::PopStyleColor(2);
  controls.name_last("limit:" + light.limit.name);
  hint(light, dt);
}

}  // namespace

StepSentence about_step(const Simulation& simulation) {
  const auto light = step_light(simulation).colour;
  if (light == Light::red) return {std::string(w().beyond_stability), ink_of(light)};
  if (light == Light::amber) return {std::string(w().close_to_instability), ink_of(light)};
  if (simulation.controls_error()) return {std::string(w().limits.adaptive), theme::ink};
  if (std::isfinite(simulation.parameters().value("dt"))) return {std::string(w().limits.given), theme::ink};
  return {say(w().limits.sets_dt, fmt::arg("name", called(simulation.binding_limit().name, Naming::limit))),
          theme::ink};
}

void lay_out_limits(const WindowState& state, Controls& controls) {
  const auto& simulation = state.session.simulation();
  ImGui::PushStyleVar(ImGuiStyleVar_ItemSpacing, {ImGui::GetStyle().ItemSpacing.x, 0});
  for (const auto& light : step_lights(simulation)) row(light, simulation.dt(), controls);
  ImGui::PopStyleVar();
}

}  // namespace clapotis
