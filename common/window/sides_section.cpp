#include "common/window/sides_section.hpp"

#include "common/window/combo.hpp"
#include "common/window/paragraph.hpp"
#include "common/words.hpp"
#include "imgui.h"

namespace clapotis {
namespace {

constexpr const char* typed = "sides:value";  ///< what `typing` calls the right side's value

}  // namespace

void SidesSection::lay_out(WindowState& state, Controls& controls) {
  const bool on = state.session.sides() != nullptr;
  if (on) ImGui::PushStyleColor(ImGuiCol_Button, ImGui::GetStyleColorVec4(ImGuiCol_ButtonActive));
  const bool toggled =
      controls.button("sides", words().window.sides.button, ImGui::GetContentRegionAvail().x);
  if (on) ImGui::PopStyleColor();
  if (on) contrast(state, controls);
  if (toggled) state.toggle_sides();
}

/// "ν = 0.02", one half of the row for what differs, the other for the right side's value.
void SidesSection::contrast(WindowState& state, Controls& controls) {
  const float whole = ImGui::GetContentRegionAvail().x, gap = ImGui::GetStyle().ItemInnerSpacing.x;
  const float sign = ImGui::CalcTextSize("=").x + 2 * gap, half = (whole - sign) / 2;
  const auto names = contrasts(state.session.simulation());
  const auto chosen = combo(state, controls, "contrast", names, state.session.sides()->contrast().name, half);
  ImGui::SameLine(0, gap);
  text("=");
  ImGui::SameLine(0, gap);
  other_value(state, controls, half);
  if (chosen) state.attempt([&] { state.session.differ_in(names[*chosen]); });
}

/// A list of what there is, or a number that is typed.
void SidesSection::other_value(WindowState& state, Controls& controls, float width) {
  const auto contrast = state.session.sides()->contrast();
  const auto values = contrast_values(state.session.simulation(), contrast.name);
  if (values.empty()) return type(state, controls, width);
  if (const auto k = combo(state, controls, "other", values, contrast.value, width))
    state.attempt([&] { state.session.choose_other(values[*k]); });
}

/// Shows the number; a click turns it into a field.
void SidesSection::type(WindowState& state, Controls& controls, float width) {
  const auto value = state.session.sides()->contrast().value;
  if (state.typing == typed) {
    ImGui::SetNextItemWidth(width);
    const auto entered = text_.lay_out(state, "##other_text");
    controls.name_last("other");
    if (entered) state.attempt([&] { state.session.choose_other(*entered); });
  } else if (controls.button("other", value, width)) {
    text_.begin(state, typed, value);
  }
}

}  // namespace clapotis
