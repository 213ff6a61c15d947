#include "common/window/typed_text.hpp"

#include <algorithm>
#include <cstring>
#include <utility>

#include "imgui.h"

namespace clapotis {

void TypedText::begin(WindowState& state, const std::string& name, const std::string& text) {
  state.typing = name;
  text_.fill('\0');
  std::memcpy(text_.data(), text.data(), std::min(text.size(), text_.size() - 1));
  focus_ = true;
}

std::optional<std::string> TypedText::lay_out(WindowState& state, const char* label) {
  const bool first = std::exchange(focus_, false);
  if (first) ImGui::SetKeyboardFocusHere();
  const bool entered =
      ImGui::InputText(label, text_.data(), text_.size(),
                       ImGuiInputTextFlags_EnterReturnsTrue | ImGuiInputTextFlags_AutoSelectAll);
  if (entered || (!first && ImGui::IsItemDeactivated())) state.typing.clear();
  return entered ? std::optional<std::string>(text_.data()) : std::nullopt;
}

}  // namespace clapotis
