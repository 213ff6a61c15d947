#include "common/window/controls.hpp"

#include <fmt/core.h>

#include "imgui.h"

namespace clapotis {

void Controls::name_last(const std::string& name) {
  if (!trace_.active()) return;
  const auto least = ImGui::GetItemRectMin(), most = ImGui::GetItemRectMax();
  const std::array<int, 4> place{static_cast<int>(least.x), static_cast<int>(least.y),
                                 static_cast<int>(most.x - least.x), static_cast<int>(most.y - least.y)};
  auto& known = places_[name];
  if (known == place) return;
  known = place;
  trace_.place(fmt::format("control {} {} {} {} {}", name, place[0], place[1], place[2], place[3]));
}

}  // namespace clapotis
