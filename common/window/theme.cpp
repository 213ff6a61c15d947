#include "common/window/theme.hpp"

#include "imgui.h"

namespace clapotis::theme {
namespace {

ImVec4 of(Colour c, float opacity = 1) { return {c.red, c.green, c.blue, c.opacity * opacity}; }
constexpr Colour white{1, 1, 1};

/// A share of the way from one colour to another: what the mouse is over moves towards the accent.
ImVec4 mix(Colour from, Colour to, float share) {
  const auto part = [share](float a, float b) { return a + share * (b - a); };
  return {part(from.red, to.red), part(from.green, to.green), part(from.blue, to.blue), 1};
}

}  // namespace

ImVec4 vec(Colour colour) { return of(colour); }

// The bold face is the second that was loaded, where it is installed.
Bold::Bold() {
  const auto& fonts = ImGui::GetIO().Fonts->Fonts;
#if IMGUI_VERSION_NUM >= 19200
  ImGui::PushFont(fonts.back(), 0);
#else
  ImGui::PushFont(fonts.back());
#endif
}

Bold::~Bold() { ImGui::PopFont(); }

Main::Main() {
  ImGui::PushStyleColor(ImGuiCol_Button, of(accent));
  ImGui::PushStyleColor(ImGuiCol_ButtonHovered, mix(accent, white, 0.12F));
  ImGui::PushStyleColor(ImGuiCol_ButtonActive, mix(accent, {0, 0, 0}, 0.2F));
  ImGui::PushStyleColor(ImGuiCol_Text, of(white));
}

Main::~Main() { ImGui::PopStyleColor(4); }

void apply(double scale) {
  auto& style = ImGui::GetStyle() = ImGuiStyle();  // distances are multiplied below: never twice
  if (ink::theme() == ink::Theme::dark)
    ImGui::StyleColorsDark();
  else
    ImGui::StyleColorsLight();
  style.WindowPadding = {14, 10};
  style.FramePadding = {8, 3};
  style.ItemSpacing = {8, 5};  // so that the panel of a cloud fits 720 rows
  style.ItemInnerSpacing = {6, 4};
  style.ScrollbarSize = 14;
  style.GrabMinSize = 10;
  style.WindowRounding = 0;
  style.FrameRounding = style.GrabRounding = style.PopupRounding = 4;
  style.WindowBorderSize = 0;
  style.FrameBorderSize = 1;
  style.ScaleAllSizes(static_cast<float>(scale));
  const auto& p = ink::palette();
  auto* colours = style.Colors;
  colours[ImGuiCol_Text] = of(p.text);
  colours[ImGuiCol_TextDisabled] = of(p.faint_text);
  colours[ImGuiCol_WindowBg] = of(p.panel);
  colours[ImGuiCol_ChildBg] = of(p.panel, 0);
  colours[ImGuiCol_PopupBg] = of(p.field);
  colours[ImGuiCol_Border] = of(p.grid);
  colours[ImGuiCol_FrameBg] = of(p.field);
  colours[ImGuiCol_FrameBgHovered] = mix(p.field, p.accent, 0.08F);
  colours[ImGuiCol_FrameBgActive] = mix(p.field, p.accent, 0.14F);
  colours[ImGuiCol_Button] = of(p.button);
  colours[ImGuiCol_ButtonHovered] = mix(p.button, p.accent, 0.14F);
  colours[ImGuiCol_ButtonActive] = mix(p.button, p.accent, 0.32F);
  colours[ImGuiCol_SliderGrab] = of(p.accent, 0.42F);
  colours[ImGuiCol_SliderGrabActive] = of(p.accent, 0.6F);
  colours[ImGuiCol_CheckMark] = of(p.accent);
  colours[ImGuiCol_Header] = mix(p.field, p.accent, 0.16F);
  colours[ImGuiCol_HeaderHovered] = mix(p.field, p.accent, 0.24F);
  colours[ImGuiCol_HeaderActive] = mix(p.field, p.accent, 0.34F);
  colours[ImGuiCol_Tab] = of(p.button);
  colours[ImGuiCol_TabHovered] = mix(p.button, p.accent, 0.14F);
#if IMGUI_VERSION_NUM >= 19090
  colours[ImGuiCol_TabSelected] = mix(p.field, p.accent, 0.34F);
#else
  colours[ImGuiCol_TabActive] = mix(p.field, p.accent, 0.34F);
#endif
  colours[ImGuiCol_Separator] = of(p.grid);
  colours[ImGuiCol_TextSelectedBg] = of(p.accent, 0.30F);
}

}  // namespace clapotis::theme
