#include "common/window/time_line.hpp"

#include <algorithm>

#include "common/window/paragraph.hpp"
#include "common/window/theme.hpp"
#include "common/words.hpp"
#include "imgui.h"

namespace clapotis {
namespace {

constexpr double height = 36;  // [pixel] at scale 1

std::string seconds(double time) { return fmt::format("{:.3f} s", time); }

}  // namespace

double time_line_height(double scale) { return height * scale; }

void lay_out_time_line(WindowState& state, const Box& area, Controls& controls) {
  auto& session = state.session;
  const auto& words_of_past = words().window.past;
  ImGui::SetNextWindowPos({static_cast<float>(area.corner.x), static_cast<float>(area.corner.y)});
  ImGui::SetNextWindowSize({static_cast<float>(area.extent.x), static_cast<float>(area.extent.y)});
  ImGui::PushStyleVar(ImGuiStyleVar_WindowMinSize, {1, 1});
  ImGui::PushStyleVar(
      ImGuiStyleVar_WindowPadding,
      {ImGui::GetStyle().WindowPadding.x, (static_cast<float>(area.extent.y) - ImGui::GetFrameHeight()) / 2});
  ImGui::Begin("time line", nullptr,
               ImGuiWindowFlags_NoDecoration | ImGuiWindowFlags_NoMove | ImGuiWindowFlags_NoSavedSettings |
                   ImGuiWindowFlags_NoBringToFrontOnFocus);
  if (ImGui::ArrowButton("back", ImGuiDir_Left)) state.step_back(ImGui::GetIO().KeyShift);
  controls.name_last("back");
  if (ImGui::IsItemHovered()) ImGui::SetTooltip("%s", std::string(words_of_past.back_hint).c_str());
  ImGui::SameLine();
  // What it was while it is dragged: a time line that shrinks under the mouse cannot be aimed at.
  const double oldest = session.past().oldest().time;
  const double now = session.simulation().time(), newest = std::max(session.past().newest().time, now);
  const auto first = seconds(oldest), last = seconds(newest);
  ImGui::AlignTextToFramePadding();
  text(first);
  ImGui::SameLine();
  const float gap = ImGui::GetStyle().ItemSpacing.x;
  ImGui::SetNextItemWidth(ImGui::GetContentRegionAvail().x - gap - ImGui::CalcTextSize(last.c_str()).x);
  double wanted = now;
  const auto shown = say(words_of_past.shown_time, fmt::arg("time", fmt::format("{:.3f}", now)));
  ImGui::BeginDisabled(newest <= oldest);
  if (ImGui::SliderScalar("##time line", ImGuiDataType_Double, &wanted, &oldest, &newest, shown.c_str(),
                          ImGuiSliderFlags_NoInput | ImGuiSliderFlags_NoRoundToFormat))
    session.go_to(wanted);
  ImGui::EndDisabled();
  controls.name_last("time_line");
  ImGui::SameLine();
  text(last);
  ImGui::End();
  ImGui::PopStyleVar(2);
}

}  // namespace clapotis
