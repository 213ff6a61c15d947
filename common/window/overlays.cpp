#include "common/window/overlays.hpp"

#include <algorithm>
#include <string>
#include <vector>

#include "common/window/keys.hpp"
#include "common/window/paragraph.hpp"
#include "common/window/theme.hpp"
#include "common/words.hpp"
#include "imgui.h"

namespace clapotis {
namespace {

constexpr int plain_box = ImGuiWindowFlags_NoDecoration | ImGuiWindowFlags_NoMove |
                          ImGuiWindowFlags_NoSavedSettings | ImGuiWindowFlags_AlwaysAutoResize |
                          ImGuiWindowFlags_NoFocusOnAppearing;

const Words::Window& w() { return words().window; }

/// A box whose point (share_x, share_y) lies at that share of the area.
void begin_box(const char* name, const Box& area, float share_x, float share_y, int flags = 0) {
  const ImVec2 at{static_cast<float>(area.corner.x + static_cast<double>(share_x) * area.extent.x),
                  static_cast<float>(area.corner.y + static_cast<double>(share_y) * area.extent.y)};
  ImGui::SetNextWindowPos(at, ImGuiCond_Always, {share_x, share_y});
  ImGui::PushStyleColor(ImGuiCol_WindowBg, theme::vec(theme::field));
  ImGui::PushStyleVar(ImGuiStyleVar_WindowBorderSize, 1);
  ImGui::Begin(name, nullptr, plain_box | flags);
}

void end_box() {
  ImGui::End();
  ImGui::PopStyleVar();
  ImGui::PopStyleColor();
}

float text_room(const Box& area, double scale) {
  return static_cast<float>(std::min(area.extent.x - 60 * scale, 640 * scale));
}

}  // namespace

void lay_out_divergence(WindowState& state, const Box& area, Controls& controls) {
  const auto& reason = state.session.diverged();
  if (!reason || state.session.sides() != nullptr) return;  // of two sides each says it in its own half
  begin_box("divergence", area, 0.5F, 0.97F);  // over the plots: the scene shows where it happened
  {
    theme::Bold bold;
    ImGui::TextColored(theme::vec(theme::warning), "%s", std::string(w().diverged).c_str());
  }
  paragraph(reason->what(), text_room(area, state.scale));
  ImGui::Spacing();
  const auto smaller =
      say(w().limits.smaller_step, fmt::arg("dt", fmt::format("{:.2g}", state.session.half_step())));
  const bool reset = controls.button("diverged:reset", w().reset);
  ImGui::SameLine();
  const bool back = controls.button("diverged:back", w().limits.step_back);
  ImGui::AlignTextToFramePadding();
  text(w().try_another);
  ImGui::SameLine();
  const bool halve = controls.button("diverged:dt", smaller);
  std::string other;
  for (const auto& name : integrator_names(state.session.simulation().setup().matter())) {
    if (name == state.session.simulation().integrator()) continue;
    if (ImGui::GetItemRectMax().x + ImGui::CalcTextSize(name.c_str()).x + 3 * ImGui::GetFrameHeight() <
        ImGui::GetWindowPos().x + text_room(area, state.scale))
      ImGui::SameLine();
    if (controls.button("diverged:" + name, name)) other = name;
  }
  end_box();
  if (reset) state.attempt([&] { state.session.reset(); });
  if (back) state.step_back(false);
  if (halve) state.attempt([&] { state.session.halve_step(); });
  if (!other.empty()) state.attempt([&] { state.session.choose_integrator(other); });
}

void lay_out_notice(WindowState& state, const Box& area, double elapsed) {
  auto& notice = state.notice;
  if (notice.seconds_left <= 0) return;
  notice.seconds_left -= elapsed;
  begin_box("notice", area, 0.5F, 0.97F, ImGuiWindowFlags_NoInputs);
  ImGui::PushStyleColor(ImGuiCol_Text, theme::vec(notice.refusal ? theme::warning : theme::ink));
  paragraph(notice.text, text_room(area, state.scale));
  ImGui::PopStyleColor();
  end_box();
}

void lay_out_recording(const WindowState& state, const Box& area) {
  if (!state.recorder.recording()) return;
  begin_box("recording", area, 0.5F, 0, ImGuiWindowFlags_NoInputs);
  const auto seconds = fmt::format("{:.1f}", state.recorder.seconds());
  const float side = ImGui::GetTextLineHeight();
  const auto corner = ImGui::GetCursorScreenPos();
  ImGui::GetWindowDrawList()->AddCircleFilled({corner.x + side / 2, corner.y + side / 2}, 0.36F * side,
                                              ImGui::GetColorU32(theme::vec(theme::warning)));
  ImGui::Dummy({side, side});
  ImGui::SameLine();
  text(say(w().recording, fmt::arg("seconds", seconds)));
  end_box();
}

void lay_out_help(WindowState& state, const Box& area) {
  if (!state.help) return;
  begin_box("help", area, 0.5F, 0.45F);
  {
    theme::Bold bold;
    text(w().help_title);
  }
  ImGui::SameLine();
  ImGui::TextDisabled("   %s", std::string(w().help_close).c_str());
  ImGui::Separator();
  // Keys that do the same share a line.
  std::vector<std::pair<std::string, std::string_view>> lines;
  for (const auto& shortcut : shortcuts()) {
    const auto does = w().*shortcut.does;
    const std::string label(called(shortcut.label));
    if (lines.empty() || lines.back().second != does) {
      lines.emplace_back(label, does);
    } else if (!lines.back().first.ends_with(label)) {
      lines.back().first += "  " + label;
    }
  }
  lines.emplace_back(w().key_click, w().does_select);
  lines.emplace_back(w().key_right, w().does_right);
  lines.emplace_back(w().key_wheel, w().does_zoom);
  lines.emplace_back(w().key_middle_drag, w().does_pan);
  lines.emplace_back(w().key_control_click, w().does_type);
  if (ImGui::BeginTable("keys", 2, ImGuiTableFlags_SizingFixedFit)) {
    for (const auto& [keys, does] : lines) {
      ImGui::TableNextColumn();
      {
        theme::Bold bold;
        text(keys + "   ");
      }
      ImGui::TableNextColumn();
      text(does);
    }
    ImGui::EndTable();
  }
  end_box();
}

}  // namespace clapotis
