#include "common/window/parameter_rows.hpp"

#include <algorithm>
#include <cmath>

#include "common/integrators/bogacki_shampine.hpp"
#include "common/simulation/time_step.hpp"
#include "common/window/slider_span.hpp"
#include "common/window/theme.hpp"
#include "common/words.hpp"
#include "imgui.h"

namespace clapotis {
namespace {

/// Where a row's field begins and how wide it is; what remains to the right is the allowed range's.
constexpr float field_at = 0.31F, field_width = 0.47F;

bool has_no_end(const Parameter& p) { return p.integer && p.range.high > 1e9; }

/// The number that the user sees, as text: what a slider shows is what it sets.
std::string rounded_text(const Parameter& p, double value) {
  return p.integer ? fmt::format("{:.0f}", value) : fmt::format("{:.4g}", value);
}

}  // namespace

/// Appears once the mouse has come to rest on the item.
void ParameterRows::tooltip(const Parameter& p) const {
  if (still_ < 0.5 || !ImGui::IsItemHovered()) return;
  const auto text =
      say(words().window.type_hint, fmt::arg("meaning", meaning(p.name)), fmt::arg("allowed", p.allowed()));
  ImGui::BeginTooltip();
  ImGui::TextUnformatted(text.c_str());
  ImGui::EndTooltip();
}

ParameterRows::Group ParameterRows::group_of(const Parameter& parameter) {
  if (has_no_end(parameter)) return Group::stepped;
  if (parameter.name == step_parameter.name || parameter.name == cfl_parameter.name ||
      parameter.name == tolerance_parameter.name)
    return Group::time_step;
  return parameter.change == Change::live && !parameter.derived ? Group::live : Group::restart;
}

void ParameterRows::lay_out(WindowState& state, Controls& controls, Group group) {
  if (group == Group::live) {
    const auto& io = ImGui::GetIO();
    const bool moves = io.MouseDelta.x != 0 || io.MouseDelta.y != 0 || ImGui::IsAnyMouseDown();
    still_ = moves ? 0 : still_ + static_cast<double>(io.DeltaTime);
  }
  const auto& simulation = state.session.simulation();
  for (const auto& parameter : simulation.parameters().all()) {
    if (group_of(parameter) != group) continue;
    if (parameter.name == tolerance_parameter.name && !simulation.controls_error()) continue;
    ImGui::PushID(parameter.name.c_str());
    row(state, controls, parameter);
    ImGui::PopID();
  }
  apply(state);
}

/// After all rows: a change may build the scene, and with it the table of parameters, anew.
void ParameterRows::apply(WindowState& state) {
  if (!wanted_) return;
  const auto wanted = *std::exchange(wanted_, std::nullopt);
  state.attempt([&] { state.session.set(wanted.name, wanted.text); });
}

void ParameterRows::row(WindowState& state, Controls& controls, const Parameter& parameter) {
  const float width = ImGui::GetContentRegionAvail().x, start = ImGui::GetCursorPosX();
  const auto& length_unit = state.session.simulation().scene().length_unit;
  ImGui::AlignTextToFramePadding();
  ImGui::TextUnformatted(printed_symbol(parameter).c_str());
  tooltip(parameter);
  if (const auto unit = printed_unit(parameter, length_unit); !unit.empty()) {
    ImGui::SameLine(0, 6 * static_cast<float>(state.scale));
    ImGui::TextDisabled("[%s]", unit.c_str());
  }
  ImGui::SameLine(start + field_at * width);
  if (parameter.derived) {
    ImGui::TextUnformatted(short_number(parameter.value).c_str());
    return;
  }
  field(state, parameter, field_width * width);
  controls.name_last(parameter.name);
  if (state.typing != parameter.name) tooltip(parameter);
  ImGui::SameLine(start + (field_at + field_width) * width, 8 * static_cast<float>(state.scale));
  if (parameter.automatic) {
    automatic(state, parameter);
    controls.name_last(parameter.name + ":auto");
  } else {
    ImGui::TextDisabled("%s", parameter.choices.empty() ? short_range(parameter.range).c_str() : "");
  }
}

void ParameterRows::field(WindowState& state, const Parameter& parameter, float width) {
  ImGui::SetNextItemWidth(width);
  if (!parameter.choices.empty()) return choice(state, parameter);
  if (state.typing == parameter.name) return text_field(state, parameter);
  if (parameter.list) return text_button(state, parameter, width);
  const ImVec2 corner = ImGui::GetCursorScreenPos();
  const ImVec2 opposite{corner.x + width, corner.y + ImGui::GetFrameHeight()};
  const bool on_it = ImGui::IsWindowHovered() && ImGui::IsMouseHoveringRect(corner, opposite);
  const bool ask = ImGui::IsMouseClicked(1) || (ImGui::IsMouseClicked(0) && ImGui::GetIO().KeyCtrl);
  if (on_it && ask) {
    type(state, parameter);
    return text_field(state, parameter);
  }
  slider(state, parameter);
}

void ParameterRows::slider(WindowState& state, const Parameter& parameter) {
  const auto& simulation = state.session.simulation();
  const bool held = dragged_ && dragged_->name == parameter.name;
  const double present =
      parameter.automatic && !std::isfinite(parameter.value) ? simulation.dt() : parameter.value;
  double value = held ? dragged_->value : present;
  const Parameter* home = state.session.defaults().find(parameter.name);
  const auto span = slider_span(home != nullptr ? *home : parameter, present, simulation);
  // A format without a conversion is shown as it stands: ImGui would write 150000 as 1.5e+05. Its own
  // logarithmic slider needs the conversion, so the slider moves the logarithm.
  const bool follows = parameter.automatic && !std::isfinite(parameter.value);
  const auto shown = follows             ? step_text(simulation)
                     : parameter.integer ? fmt::format("{:.0f}", value)
                                         : short_number(value);
  const auto to_slider = [&span](double x) { return span.logarithmic ? std::log10(x) : x; };
  const double low = to_slider(span.low), high = to_slider(span.high);
  double place = to_slider(value);
  const bool moved = ImGui::SliderScalar("##value", ImGuiDataType_Double, &place, &low, &high, shown.c_str(),
                                         ImGuiSliderFlags_NoInput);
  if (moved) value = span.logarithmic ? std::pow(10, place) : place;
  const bool let_go = ImGui::IsItemDeactivated();
  if (parameter.change == Change::live) {
    if (moved) wanted_ = {parameter.name, rounded_text(parameter, value)};
    return;
  }
  if (moved) dragged_ = {parameter.name, value};
  if (!let_go || !dragged_) return;
  wanted_ = {parameter.name, rounded_text(parameter, dragged_->value)};
  dragged_.reset();
}

void ParameterRows::type(WindowState& state, const Parameter& parameter) {
  text_.begin(state, parameter.name, parameter.text());
}

void ParameterRows::text_field(WindowState& state, const Parameter& parameter) {
  if (const auto entered = text_.lay_out(state, "##text")) wanted_ = {parameter.name, *entered};
}

/// Shows the value; a click turns it into a field.
void ParameterRows::text_button(WindowState& state, const Parameter& parameter, float width) {
  if (ImGui::Button((parameter.text() + "##text").c_str(), {width, 0})) type(state, parameter);
}

void ParameterRows::choice(WindowState& state, const Parameter& parameter) {
  const auto now = static_cast<std::size_t>(parameter.value);
  if (!ImGui::BeginCombo("##choice", parameter.choices[now].c_str())) return;
  state.menu_open = true;
  if (state.close_menu) ImGui::CloseCurrentPopup();
  for (std::size_t k = 0; k < parameter.choices.size(); ++k) {
    if (ImGui::Selectable(parameter.choices[k].c_str(), k == now) && k != now)
      wanted_ = {parameter.name, parameter.choices[k]};
  }
  ImGui::EndCombo();
}

void ParameterRows::automatic(WindowState& state, const Parameter& parameter) {
  bool on = !std::isfinite(parameter.value);
  if (!ImGui::Checkbox(std::string(words().window.automatic).c_str(), &on)) return;
  wanted_ = {parameter.name, on ? "auto" : to_text(state.session.simulation().dt())};
}

void ParameterRows::steppers(WindowState& state, Controls& controls, float start, float width) {
  for (const auto& parameter : state.session.simulation().parameters().all()) {
    if (group_of(parameter) != Group::stepped || parameter.derived) continue;
    ImGui::PushID(parameter.name.c_str());
    ImGui::AlignTextToFramePadding();
    ImGui::TextUnformatted(printed_symbol(parameter).c_str());
    tooltip(parameter);
    ImGui::SameLine(start);
    const float side = ImGui::GetFrameHeight(), gap = ImGui::GetStyle().ItemInnerSpacing.x;
    const float middle = width - 2 * side - 2 * gap;
    const auto ask = [&](double value) {
      if (parameter.range.contains(value)) wanted_ = {parameter.name, fmt::format("{:.0f}", value)};
    };
    if (ImGui::Button("−", {side, 0})) ask(parameter.value - 1);
    controls.name_last(parameter.name + ":less");
    ImGui::SameLine(0, gap);
    ImGui::SetNextItemWidth(middle);
    if (state.typing == parameter.name) {
      text_field(state, parameter);
    } else {
      text_button(state, parameter, middle);
    }
    controls.name_last(parameter.name);
    ImGui::SameLine(0, gap);
    if (ImGui::Button("+", {side, 0})) ask(parameter.value + 1);
    controls.name_last(parameter.name + ":more");
    ImGui::PopID();
  }
  apply(state);
}

}  // namespace clapotis
