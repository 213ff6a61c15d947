#include "common/window/lesson_tab.hpp"

#include <utility>

#include "common/runner/units.hpp"
#include "common/window/paragraph.hpp"
#include "common/window/theme.hpp"
#include "common/words.hpp"
#include "imgui.h"

namespace clapotis {
namespace {

const Words::Lesson& w() { return words().lesson; }

float room() { return ImGui::GetContentRegionAvail().x; }

void heading(std::string_view words) {
  theme::Bold bold;
  text(words);
}

std::string in_digits(double value) { return fmt::format("{:.4g}", value); }

std::string with_unit(const std::string& value, const Check& check) {
  return check.unit.empty() ? value : value + " " + printed(check.unit);
}

/// "error (t = 0.4 s)", "right: force_evaluations".
std::string what(const Check& check) {
  auto text = check.quantity;
  if (!check.side.empty())
    text = std::string(check.side == "left" ? words().compare_left : words().compare_right) + ", " + text;
  if (check.time) text += fmt::format(" (t = {:g} s)", *check.time);
  return text;
}

std::string expected(const Check& check) {
  using enum Check::Relation;
  if (check.relation == below) return "< " + with_unit(in_digits(check.value), check);
  if (check.relation == above) return "> " + with_unit(in_digits(check.value), check);
  auto text = with_unit(in_digits(check.value), check);
  if (check.tolerance >= 1e-3) text += fmt::format(" ± {:.2g} %", 100 * check.tolerance);
  return text;
}

void coloured(const std::string& text, Colour colour) {
  ImGui::PushStyleColor(ImGuiCol_Text, theme::vec(colour));
  paragraph(text, room());
  ImGui::PopStyleColor();
}

}  // namespace

bool LessonTab::lay_out(WindowState& state) {
  if (state.lesson.empty()) return false;
  const auto tab = [&](const std::string& name, std::string_view label) {
    const bool chosen = ImGui::BeginTabItem((std::string(label) + "###" + name).c_str());
    controls_.name_last(name);
    if (chosen) ImGui::EndTabItem();
    return chosen;
  };
  state.lesson_shown = false;
  if (ImGui::BeginTabBar("tabs")) {
    tab("tab:scene", w().tab_scene);
    state.lesson_shown = tab("tab:lesson", w().tab_lesson);
    ImGui::EndTabBar();
  }
  if (!state.lesson_shown) return false;
  auto& lesson = state.lesson;
  pages(lesson);
  const float below = ImGui::GetFrameHeightWithSpacing();  // the button's, which stays in view
  ImGui::BeginChild("lesson", {0, -below});
  const auto& wording = lesson.exercise().wording();
  {
    theme::Bold bold;
    paragraph(wording.title, room());
  }
  paragraph(printed(wording.predict), room());
  ImGui::Spacing();
  heading(w().run);
  for (std::size_t k = 0; k < lesson.exercise().runs.size(); ++k) run(state, k);
  if (lesson.answer_shown()) {
    ImGui::Separator();
    if (std::exchange(scroll_to_answer_, false)) ImGui::SetScrollHereY(0.4F);  // runs stay in view, too
    paragraph(printed(wording.explain), room());
  }
  ImGui::EndChild();
  if (controls_.button("lesson:answer", lesson.answer_shown() ? w().hide_answer : w().show_answer, room())) {
    lesson.toggle_answer();
    scroll_to_answer_ = lesson.answer_shown();
  }
  return true;
}

void LessonTab::pages(LessonPlay& lesson) {
  const float side = ImGui::GetFrameHeight(), end = ImGui::GetCursorPosX() + room();
  ImGui::BeginDisabled(lesson.place() == 0);
  if (controls_.button("lesson:previous", "←", side)) lesson.turn(-1);
  ImGui::EndDisabled();
  ImGui::SameLine();
  ImGui::AlignTextToFramePadding();
  const auto where =
      say(w().exercise, fmt::arg("number", lesson.place() + 1), fmt::arg("count", lesson.count()));
  const float middle = ImGui::GetCursorPosX();
  ImGui::SetCursorPosX(middle + (end - side - middle - ImGui::CalcTextSize(where.c_str()).x) / 2);
  text(where);
  ImGui::SameLine(end - side);
  ImGui::BeginDisabled(lesson.place() + 1 == lesson.count());
  if (controls_.button("lesson:next", "→", side)) lesson.turn(1);
  ImGui::EndDisabled();
}

/// A button and what it sets, or the command for a terminal where the window cannot do it; then what it gave.
void LessonTab::run(WindowState& state, std::size_t number) {
  auto& lesson = state.lesson;
  const auto& run = lesson.exercise().runs[number];
  const float start = ImGui::GetCursorPosX(), width = 2 * ImGui::GetFrameHeight();
  bool pressed = false;
  if (lesson.can_start(run)) {
    const auto label = fmt::format("▶ {}", number + 1), name = fmt::format("lesson:run{}", number + 1);
    if (lesson.progress(number) == LessonPlay::Progress::running) {
      theme::Main main;
      pressed = controls_.button(name, label, width);
    } else {
      pressed = controls_.button(name, label, width);
    }
    ImGui::SameLine();
    ImGui::AlignTextToFramePadding();
    ImGui::BeginGroup();
    paragraph(run.summary(), room());
    ImGui::EndGroup();
  } else {
    coloured(fmt::format("{}  {} {}", number + 1, std::string_view(w().in_terminal), run.text), theme::faint);
  }
  const float indent = width + ImGui::GetStyle().ItemSpacing.x;
  ImGui::Indent(indent);
  for (std::size_t k = 0; k < lesson.exercise().checks.size(); ++k)
    if (lesson.exercise().checks[k].run == number) check(lesson, k);
  if (lesson.progress(number) == LessonPlay::Progress::changed)
    coloured(std::string(w().changed), theme::caution);
  ImGui::Unindent(indent);
  ImGui::SetCursorPosX(start);
  if (pressed) state.attempt([&] { lesson.start(number, state.session); });
}

/// "error = 0.00531 m", and with the answer what was expected, with a tick or a cross; both in a line where
/// it is long enough.
void LessonTab::check(const LessonPlay& lesson, std::size_t number) {
  const auto& check = lesson.exercise().checks[number];
  const auto& measured = lesson.findings().measured(number);
  const bool starts = lesson.can_start(lesson.exercise().runs[check.run]);
  if (!starts && !lesson.answer_shown()) return;
  const float whole = room();
  const auto found = measured ? with_unit(in_digits(*measured), check) : std::string("…");
  const auto left = starts ? what(check) + " = " + found : what(check);
  coloured(left, measured ? theme::ink : theme::faint);
  if (!lesson.answer_shown()) return;
  const bool holds = measured && check.holds(*measured);
  const auto text = std::string(!measured ? ""
                                : holds   ? "✓ "
                                          : "✗ ") +
                    say(w().expected, fmt::arg("value", expected(check)));
  const auto width = [](const std::string& line) { return ImGui::CalcTextSize(line.c_str()).x; };
  if (width(left) + width(text) + ImGui::GetStyle().ItemSpacing.x < whole) ImGui::SameLine();
  coloured(text, !measured ? theme::faint : holds ? ink::plain_disc : theme::warning);
}

}  // namespace clapotis
