#include "common/window/controls.hpp"

#include <fmt/core.h>

#include <cmath>

#include "imgui.h"

namespace clapotis {

void Controls::name_last(const std::string& name) {
  const auto least = ImGui::GetItemRectMin(), size = ImGui::GetItemRectSize();
  this->name(name, {{static_cast<double>(least.x), static_cast<double>(least.y)},
                    {static_cast<double>(size.x), static_cast<double>(size.y)}});
}

bool Controls::button(const std::string& name, std::string_view label, float width) {
  const bool pressed = ImGui::Button((std::string(label) + "###" + name).c_str(), {width, 0});
  name_last(name);
  return pressed;
}

void Controls::name(const std::string& name, const Box& place) {
  if (!trace_.active()) return;
  const auto pixel = [](double value) { return static_cast<int>(std::lround(value)); };
  const std::array<int, 4> now{pixel(place.corner.x), pixel(place.corner.y), pixel(place.extent.x),
                               pixel(place.extent.y)};
  auto& known = places_[name];
  if (known == now) return;
  known = now;
  trace_.place(fmt::format("control {} {} {} {} {}", name, now[0], now[1], now[2], now[3]));
}

}  // namespace clapotis
