#include "common/window/sides_section.hpp"

#include <algorithm>
#include <cstring>
#include <string>
#include <utility>

#include "common/window/combo.hpp"
#include "common/window/theme.hpp"
#include "common/words.hpp"
#include "imgui.h"

namespace clapotis {
namespace {

constexpr float caption_width = 0.26F;        ///< of the panel, as of its other rows
constexpr const char* typed = "sides:value";  ///< what `typing` calls the right side's value

void caption(std::string_view words) { ImGui::TextUnformatted(words.data(), words.data() + words.size()); }

}  // namespace

void SidesSection::lay_out(WindowState& state, Controls& controls) {
  const auto& w = words().window.sides;
  const float start = ImGui::GetCursorPosX(), whole = ImGui::GetContentRegionAvail().x;
  ImGui::AlignTextToFramePadding();
  caption(w.label);
  ImGui::SameLine(start + caption_width * whole);
  bool on = state.session.sides() != nullptr;
  const bool toggled = ImGui::Checkbox(((on ? "" : std::string(w.offer)) + "###sides").c_str(), &on);
  controls.name_last("sides");
  if (state.session.sides() != nullptr) {
    const auto& simulation = state.session.simulation();
    ImGui::SameLine();
    const auto names = contrasts(simulation);
    const float width = start + whole - ImGui::GetCursorPosX();
    const auto present = state.session.sides()->contrast().name;
    if (const auto k = combo(state, controls, "contrast", names, present, width))
      state.attempt([&] { state.session.differ_in(names[*k]); });
    ImGui::AlignTextToFramePadding();
    caption(w.right);
    ImGui::SameLine(start + caption_width * whole);
    other_value(state, controls, (1 - caption_width) * whole);
  }
  if (toggled) state.toggle_sides();
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
