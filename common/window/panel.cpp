#include "common/window/panel.hpp"

#include <array>

#include "common/runner/ticks.hpp"
#include "common/simulation/tools.hpp"
#include "common/window/combo.hpp"
#include "common/window/kernel_view.hpp"
#include "common/window/limit_rows.hpp"
#include "common/window/paragraph.hpp"
#include "common/window/theme.hpp"
#include "common/words.hpp"
#include "imgui.h"

namespace clapotis {
namespace {

constexpr float label_width = 0.26F;  ///< of the panel, left of the lists

const Words::Window& w() { return words().window; }

/// One to the left, the other to the right.
void fact(const std::string& left, const std::string& right) {
  const float end = ImGui::GetCursorPosX() + ImGui::GetContentRegionAvail().x;
  text(left);
  ImGui::SameLine(end - ImGui::CalcTextSize(right.c_str()).x);
  text(right);
}

void heading(std::string_view words, const std::string& right = {}, Colour colour = theme::ink) {
  {
    theme::Bold bold;
    const float end = ImGui::GetCursorPosX() + ImGui::GetContentRegionAvail().x;
    text(words);
    if (!right.empty()) {
      ImGui::SameLine(end - ImGui::CalcTextSize(right.c_str()).x);
      ImGui::PushStyleColor(ImGuiCol_Text, theme::vec(colour));
      text(right);
      ImGui::PopStyleColor();
    }
  }
  ImGui::Separator();
}

std::string duration(double milliseconds) {
  if (milliseconds == 0) return "…";
  return milliseconds < 0.1 ? fmt::format("{:.3g} µs", 1e3 * milliseconds)
                            : fmt::format("{:.3g} ms", milliseconds);
}

}  // namespace

void Panel::lay_out(WindowState& state, const Box& area) {
  ImGui::SetNextWindowPos({static_cast<float>(area.corner.x), static_cast<float>(area.corner.y)});
  ImGui::SetNextWindowSize({static_cast<float>(area.extent.x), static_cast<float>(area.extent.y)});
  const auto padding = ImGui::GetStyle().WindowPadding;  // the whole panel of a cloud is to be seen
  ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, {padding.x, padding.y / 2});
  ImGui::Begin("panel", nullptr,
               ImGuiWindowFlags_NoTitleBar | ImGuiWindowFlags_NoResize | ImGuiWindowFlags_NoCollapse |
                   ImGuiWindowFlags_NoMove | ImGuiWindowFlags_NoSavedSettings |
                   ImGuiWindowFlags_NoBringToFrontOnFocus);
  ImGui::PopStyleVar();
  transport(state);
  if (lesson_.lay_out(state)) return ImGui::End();
  scene(state);
  mouse(state);
  parameters(state);
  time_step(state);
  view(state);
  record(state);
  cost(state);
  ImGui::End();
}

void Panel::transport(WindowState& state) {
  auto& session = state.session;
  const float gap = ImGui::GetStyle().ItemSpacing.x, width = (ImGui::GetContentRegionAvail().x - 2 * gap) / 3;
  const bool stopped = session.stopped(), runs = !session.paused() && !stopped;
  ImGui::BeginDisabled(stopped);
  {
    theme::Main main;
    if (controls_.button("pause", runs ? w().pause : w().run, width)) session.toggle_pause();
  }
  ImGui::SameLine();
  if (controls_.button("step", w().step, width)) session.step(ImGui::GetIO().KeyShift ? 10 : 1);
  ImGui::EndDisabled();
  ImGui::SameLine();
  if (controls_.button("reset", w().reset, width)) state.attempt([&] { session.reset(); });

  speed(state);
}

void Panel::speed(WindowState& state) {
  auto& session = state.session;
  const float start = ImGui::GetCursorPosX(), whole = ImGui::GetContentRegionAvail().x;
  const float side = ImGui::GetFrameHeight();
  ImGui::AlignTextToFramePadding();
  text(w().speed);
  ImGui::SameLine(start + label_width * whole);
  if (controls_.button("slower", "−", side)) session.change_speed(-1);
  ImGui::SameLine();
  ImGui::AlignTextToFramePadding();
  ImGui::Text("x%s", fmt::format("{:.4g}", session.speed()).c_str());
  ImGui::SameLine(start + label_width * whole + 4.6F * side);
  if (controls_.button("faster", "+", side)) session.change_speed(1);
  ImGui::SameLine(start + whole - side);
  if (controls_.button("help", "?", side)) state.help = !state.help;
  const auto& rates = state.cost.rates();
  if (!rates.slower_than_asked || session.paused() || session.stopped()) return;
  ImGui::SameLine();
  ImGui::AlignTextToFramePadding();
  ImGui::TextDisabled(
      "%s", say(w().slower_than_asked, fmt::arg("factor", fmt::format("{:.2g}", rates.speed))).c_str());
}

std::optional<std::size_t> Panel::list(WindowState& state, const std::string& name, std::string_view label,
                                       const std::vector<std::string>& names, const std::string& present,
                                       float share) {
  const float start = ImGui::GetCursorPosX(), whole = ImGui::GetContentRegionAvail().x;
  ImGui::AlignTextToFramePadding();
  text(label);
  ImGui::SameLine(start + label_width * whole);
  return combo(state, controls_, name, names, present, share * whole);
}

/// Beside the scene that it belongs to.
void Panel::preset(WindowState& state) {
  auto& session = state.session;
  std::vector<std::string> names;
  for (const auto& preset : session.simulation().scene().presets) names.push_back(preset.name);
  const auto shown = session.preset().empty() ? std::string(w().preset) : session.preset();
  if (const auto k = combo(state, controls_, "preset", names, shown, ImGui::GetContentRegionAvail().x))
    state.attempt([&] { session.choose_preset(names[*k]); });
}

void Panel::scene(WindowState& state) {
  auto& session = state.session;
  std::vector<std::string> names;
  for (const auto& scene : session.stage().scenes) names.push_back(scene.name);
  const auto& presets = session.simulation().scene().presets;
  const auto chosen =
      list(state, "scene", w().scene, names, names[session.scene()], presets.empty() ? 0.74F : 0.42F);
  if (!presets.empty()) {
    ImGui::SameLine();
    preset(state);
  }
  if (chosen) state.attempt([&] { session.choose_scene(*chosen); });
  const auto integrator = session.simulation().integrator();
  const auto& integrators = integrator_names(session.simulation().setup().matter());
  const auto k = list(state, "integrator", w().integrator, integrators, integrator, 0.46F);
  ImGui::SameLine();
  sides_.lay_out(state, controls_);
  if (k) state.attempt([&] { session.choose_integrator(integrators[*k]); });
  const float whole = ImGui::GetContentRegionAvail().x;
  rows_.steppers(state, controls_, ImGui::GetCursorPosX() + label_width * whole, (1 - label_width) * whole);
}

void Panel::parameters(WindowState& state) {
  const float end = ImGui::GetCursorPosX() + ImGui::GetContentRegionAvail().x;
  {
    theme::Bold bold;
    ImGui::AlignTextToFramePadding();
    text(w().live);
  }
  const std::string label(w().defaults);
  ImGui::SameLine(end - ImGui::CalcTextSize(label.c_str()).x - 2 * ImGui::GetStyle().FramePadding.x);
  if (controls_.button("defaults", label, 0)) state.attempt([&] { state.session.restore_defaults(); });
  ImGui::Separator();
  rows_.lay_out(state, controls_, ParameterRows::Group::live);
  const bool open = ImGui::CollapsingHeader((std::string(w().restart) + "###restart").c_str());
  controls_.name_last("restart");
  if (!open) return;
  rows_.lay_out(state, controls_, ParameterRows::Group::restart);
}

void Panel::time_step(WindowState& state) {
  const auto [sentence, colour] = about_step(state.session.simulation());
  heading(w().time_step, sentence, colour);
  rows_.lay_out(state, controls_, ParameterRows::Group::time_step);
  lay_out_limits(state, controls_);
}

void Panel::view(WindowState& state) {
  auto& sight = state.sight;
  auto& simulation = state.session.simulation();
  heading(w().view);
  const auto tick = [&](const std::string& name, std::string_view label, bool& value) {
    ImGui::Checkbox((std::string(label) + "###" + name).c_str(), &value);
    controls_.name_last(name);
  };
  const float start = ImGui::GetCursorPosX(), width = ImGui::GetContentRegionAvail().x;
  const auto quantities = colourings(simulation);
  if (const auto k = list(state, "colour", w().colour_by, quantities, sight.viewpoint.colour_by, 0.40F))
    sight.colour_by(quantities[*k]);
  ImGui::SameLine(start + 0.70F * width);
  tick("lock", w().lock_range, sight.colour_range.locked);
  const auto& style = ImGui::GetStyle();  // the four of a line stand close
  ImGui::PushStyleVar(ImGuiStyleVar_ItemInnerSpacing,
                      {style.ItemInnerSpacing.x / 2, style.ItemInnerSpacing.y});
  ImGui::PushStyleVar(ImGuiStyleVar_ItemSpacing, {style.ItemSpacing.x / 2, style.ItemSpacing.y});
  if (simulation.model().has_pairs()) tick("grid", w().grid, sight.viewpoint.grid);
  if (simulation.model().has_pairs()) ImGui::SameLine();
  tick("vectors", w().vectors, sight.vectors);
  ImGui::SameLine();
  lay_out_kernel_tick(state, controls_);
  tick("plots", w().plots, sight.plots);
  ImGui::PopStyleVar(2);
  look(state);
}

/// Larger letters, for a large room; and the theme, for a dark one.
void Panel::look(WindowState& state) {
  const float start = ImGui::GetCursorPosX(), width = ImGui::GetContentRegionAvail().x;
  const auto percent = [](double scale) { return fmt::format("{:.0f} %", 100 * scale); };
  std::vector<std::string> names;
  for (const double scale : scales) names.push_back(percent(scale));
  if (const auto k = list(state, "scale", w().letters, names, percent(state.scale), 0.40F))
    state.scale = scales[*k];
  ImGui::SameLine(start + 0.70F * width);
  bool dark = ink::theme() == ink::Theme::dark;
  ImGui::Checkbox((std::string(w().dark) + "###dark").c_str(), &dark);
  controls_.name_last("dark");
  ink::use(dark ? ink::Theme::dark : ink::Theme::light);
}

/// What the left button does, where there is a hand.
void Panel::mouse(WindowState& state) {
  if (!has_hand(state.session.simulation())) return;
  heading(w().mouse);
  const std::array<std::string_view, 7> labels{w().tool_probe, w().tool_pull,     w().tool_push, w().tool_add,
                                               w().tool_erase, w().tool_obstacle, w().tool_grab};
  constexpr std::size_t in_a_line = 4;
  const float gap = ImGui::GetStyle().ItemSpacing.x;
  const float width = (ImGui::GetContentRegionAvail().x - (in_a_line - 1) * gap) / in_a_line;
  for (std::size_t k = 0; k < labels.size(); ++k) {
    if (k % in_a_line > 0) ImGui::SameLine();
    const bool chosen = state.tool == static_cast<Tool>(k);
    if (chosen) ImGui::PushStyleColor(ImGuiCol_Button, ImGui::GetStyleColorVec4(ImGuiCol_ButtonActive));
    if (controls_.button(std::string("tool:") + tool_names[k], labels[k], width))
      state.tool = static_cast<Tool>(k);
    if (chosen) ImGui::PopStyleColor();
  }
}

/// Low, so that the whole panel of a cloud is seen in a window of 720 rows.
void Panel::record(WindowState& state) {
  const float gap = ImGui::GetStyle().ItemSpacing.x, whole = ImGui::GetContentRegionAvail().x;
  const std::array<std::string_view, 6> labels{
      w().picture, state.recorder.recording() ? w().stop_video : w().video,
      w().table,   w().grid_file,
      w().save,    w().restore};
  constexpr std::array names{"picture", "video", "table", "grid_file", "save", "restore"};
  float letters = 0;
  for (const auto label : labels) letters += ImGui::CalcTextSize(label.data(), label.data() + label.size()).x;
  const float margins = (whole - letters) / static_cast<float>(labels.size()) - gap;
  ImGui::PushStyleVar(ImGuiStyleVar_FramePadding, {std::max(margins / 2, 2.0F), 0});
  const std::array acts{+[](WindowState& s) { s.picture_wanted = true; },
                        +[](WindowState& s) { s.toggle_video(); },
                        +[](WindowState& s) { s.write_table(); },
                        +[](WindowState& s) { s.write_grid(); },
                        +[](WindowState& s) { s.save(); },
                        +[](WindowState& s) { s.restore(); }};
  for (std::size_t k = 0; k < labels.size(); ++k) {
    if (k > 0) ImGui::SameLine();
    const bool nothing_saved = k + 1 == labels.size() && state.recorder.saved().empty();
    ImGui::BeginDisabled(nothing_saved);
    if (controls_.button(names[k], labels[k], 0)) acts[k](state);
    ImGui::EndDisabled();
  }
  ImGui::PopStyleVar();
}

/// Its lines are close, so that the whole panel of a cloud is seen in a window of 720 rows.
void Panel::cost(WindowState& state) {
  const auto& spacing = ImGui::GetStyle().ItemSpacing;
  ImGui::PushStyleVar(ImGuiStyleVar_ItemSpacing, {spacing.x, spacing.y / 2});
  const auto& rates = state.cost.rates();
  heading(w().cost, rates.possible_speed > 0
                        ? say(w().real_time, fmt::arg("factor", two_digits(rates.possible_speed)))
                        : std::string());
  const long long n = state.session.simulation().particles().size();
  fact(say(w().particles, fmt::arg("count", grouped(n))),
       say(w().step_cost, fmt::arg("time", duration(rates.step_milliseconds))));
  if (rates.pairs)
    fact(say(w().pairs_near, fmt::arg("count", grouped(rates.pairs->neighbours))),
         say(w().pairs_tested, fmt::arg("count", grouped(rates.pairs->candidates))));
  fact(say(w().frames,
           fmt::arg("count",
                    rates.frames_per_second == 0 ? "…" : fmt::format("{:.0f}", rates.frames_per_second))),
       say(w().frame_cost, fmt::arg("time", duration(rates.frame_milliseconds))));
  ImGui::PopStyleVar();
}

}  // namespace clapotis
