#include "common/window/sides_section.hpp"

#include <algorithm>
#include <cstring>
#include <string>
#include <utility>

#include "common/window/combo.hpp"
#include "common/words.hpp"
#include "imgui.h"

namespace clapotis {
namespace {

constexpr const char* typed = "sides:value";  ///< what `typing` calls the right side's value

}  // namespace

void SidesSection::lay_out(WindowState& state, Controls& controls) {
  const bool on = state.session.sides() != nullptr;
  if (on) ImGui::PushStyleColor(ImGuiCol_Button, ImGui::GetStyleColorVec4(ImGuiCol_ButtonActive));
  const auto label = std::string(words().window.sides.button) + "###sides";
  const bool toggled = ImGui::Button(label.c_str(), {ImGui::GetContentRegionAvail().x, 0});
  if (on) ImGui::PopStyleColor();
  controls.name_last("sides");
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
  ImGui::TextUnformatted("=");
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
  if (state.typing != typed) {
    if (ImGui::Button((value + "###other").c_str(), {width, 0})) {
      state.typing = typed;
      text_.fill('\0');
      std::memcpy(text_.data(), value.data(), std::min(value.size(), text_.size() - 1));
      focus_ = true;
    }
    controls.name_last("other");
    return;
  }
  const bool first = std::exchange(focus_, false);
  if (first) ImGui::SetKeyboardFocusHere();
  ImGui::SetNextItemWidth(width);
  const bool entered =
      ImGui::InputText("##other_text", text_.data(), text_.size(),
                       ImGuiInputTextFlags_EnterReturnsTrue | ImGuiInputTextFlags_AutoSelectAll);
  controls.name_last("other");
  if (entered || (!first && ImGui::IsItemDeactivated())) state.typing.clear();
  if (entered) state.attempt([&] { state.session.choose_other(text_.data()); });
}

}  // namespace clapotis
