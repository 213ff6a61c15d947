#include "common/window/combo.hpp"

#include "common/words.hpp"
#include "imgui.h"

namespace clapotis {

std::optional<std::size_t> combo(WindowState& state, Controls& controls, const std::string& name,
                                 const std::vector<std::string>& names, const std::string& present,
                                 float width) {
  std::optional<std::size_t> chosen;
  ImGui::SetNextItemWidth(width);
  const std::string shown(called(present));
  const bool open = ImGui::BeginCombo(("##" + name).c_str(), shown.c_str(), ImGuiComboFlags_HeightLargest);
  if (!open) controls.name_last(name);
  if (!open) return chosen;
  state.menu_open = true;
  if (state.close_menu) ImGui::CloseCurrentPopup();
  for (std::size_t k = 0; k < names.size(); ++k) {
    if (ImGui::Selectable(std::string(called(names[k])).c_str(), names[k] == present)) chosen = k;
    controls.name_last(name + ":" + names[k]);
  }
  ImGui::EndCombo();
  return chosen;
}

}  // namespace clapotis
