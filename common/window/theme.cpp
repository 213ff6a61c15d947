#include "common/window/theme.hpp"

#include "imgui.h"

namespace clapotis::theme {
namespace {

ImVec4 of(Colour c, float opacity = 1) { return {c.red, c.green, c.blue, c.opacity * opacity}; }
constexpr Colour white{1, 1, 1};
constexpr Colour border{0.78f, 0.80f, 0.83f};
constexpr Colour button{0.875f, 0.895f, 0.915f};

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
  ImGui::PushStyleColor(ImGuiCol_ButtonHovered, of({0.15f, 0.44f, 0.68f}));
  ImGui::PushStyleColor(ImGuiCol_ButtonActive, of({0.07f, 0.29f, 0.48f}));
  ImGui::PushStyleColor(ImGuiCol_Text, of(white));
}

Main::~Main() { ImGui::PopStyleColor(4); }

void apply(double scale) {
  ImGui::StyleColorsLight();
  auto& style = ImGui::GetStyle();
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
  auto* colours = style.Colors;
  colours[ImGuiCol_Text] = of(ink);
  colours[ImGuiCol_TextDisabled] = of(faint);
  colours[ImGuiCol_WindowBg] = of(panel);
  colours[ImGuiCol_ChildBg] = of(panel, 0);
  colours[ImGuiCol_PopupBg] = of(white);
  colours[ImGuiCol_Border] = of(border);
  colours[ImGuiCol_FrameBg] = of(white);
  colours[ImGuiCol_FrameBgHovered] = of({0.93f, 0.955f, 0.98f});
  colours[ImGuiCol_FrameBgActive] = of({0.88f, 0.93f, 0.98f});
  colours[ImGuiCol_Button] = of(button);
  colours[ImGuiCol_ButtonHovered] = of({0.80f, 0.86f, 0.92f});
  colours[ImGuiCol_ButtonActive] = of({0.70f, 0.80f, 0.90f});
  colours[ImGuiCol_SliderGrab] = of(accent, 0.42f);
  colours[ImGuiCol_SliderGrabActive] = of(accent, 0.6f);
  colours[ImGuiCol_CheckMark] = of(accent);
  colours[ImGuiCol_Header] = of({0.86f, 0.905f, 0.95f});
  colours[ImGuiCol_HeaderHovered] = of({0.80f, 0.87f, 0.94f});
  colours[ImGuiCol_HeaderActive] = of({0.72f, 0.82f, 0.92f});
  colours[ImGuiCol_Tab] = of(button);
  colours[ImGuiCol_TabHovered] = of({0.80f, 0.86f, 0.92f});
#if IMGUI_VERSION_NUM >= 19090
  colours[ImGuiCol_TabSelected] = of({0.72f, 0.82f, 0.92f});
#else
  colours[ImGuiCol_TabActive] = of({0.72f, 0.82f, 0.92f});
#endif
  colours[ImGuiCol_Separator] = of(border);
  colours[ImGuiCol_TextSelectedBg] = of(accent, 0.30f);
}

}  // namespace clapotis::theme
