#include "common/window/keys.hpp"

#include <array>

#include "common/runner/ink.hpp"
#include "common/window/kernel_view.hpp"

namespace clapotis {
namespace {

using W = Words::Window;

void step(WindowState& state, bool shift) { state.session.step(shift ? 10 : 1); }

void step_back(WindowState& state, bool shift) { state.step_back(shift); }

void change_scene(WindowState& state, int direction) {
  const std::size_t count = state.session.stage().scenes.size();
  const std::size_t forward = direction > 0 ? 1 : count - 1;
  state.attempt([&] { state.session.choose_scene((state.session.scene() + forward) % count); });
}

void escape(WindowState& state, bool /*shift*/) {
  if (state.menu_open) {
    state.close_menu = true;
  } else if (state.help) {
    state.help = false;
  } else if (state.sight.viewpoint.chosen) {
    state.sight.viewpoint.chosen.reset();
  } else {
    state.quit = true;
  }
}

void switch_language(WindowState& /*state*/, bool /*shift*/) {
  speak(language() == Language::english ? Language::french : Language::english);
}

void select(WindowState& state, int direction) {
  state.sight.select_next(state.session.simulation(), direction);
}

void other_theme() { ink::use(ink::theme() == ink::Theme::light ? ink::Theme::dark : ink::Theme::light); }

constexpr std::array<Shortcut, 31> table{{
    {Key::space, 0, "Space", &W::does_pause, [](WindowState& s, bool) { s.session.toggle_pause(); }},
    {Key::n, 0, "N", &W::does_step, step, true},
    {Key::right, 0, "→", &W::does_step, step, true},
    {Key::left, 0, "←", &W::does_back, step_back, true},
    {Key::r, 0, "R", &W::does_reset, [](WindowState& s, bool) { s.attempt([&] { s.session.reset(); }); }},
    {Key::up, 0, "↑", &W::does_speed, [](WindowState& s, bool) { s.session.change_speed(1); }},
    {Key::down, 0, "↓", &W::does_speed, [](WindowState& s, bool) { s.session.change_speed(-1); }},
    {Key::page_up, 0, "PageUp", &W::does_scene, [](WindowState& s, bool) { change_scene(s, -1); }},
    {Key::page_down, 0, "PageDown", &W::does_scene, [](WindowState& s, bool) { change_scene(s, 1); }},
    {Key::c, 0, "C", &W::does_colour,
     [](WindowState& s, bool) { s.sight.next_colouring(s.session.simulation()); }},
    {Key::l, 0, "L", &W::does_lock,
     [](WindowState& s, bool) { s.sight.colour_range.locked = !s.sight.colour_range.locked; }},
    {Key::g, 0, "G", &W::does_grid,
     [](WindowState& s, bool) { s.sight.viewpoint.grid = !s.sight.viewpoint.grid; }},
    {Key::k, 0, "K", &W::does_kernel, [](WindowState& s, bool) { toggle_kernel(s); }},
    {Key::other, U',', ",", &W::does_neighbour, [](WindowState& s, bool) { select(s, -1); }},
    {Key::other, U'.', ".", &W::does_neighbour, [](WindowState& s, bool) { select(s, 1); }},
    {Key::other, U';', ".", &W::does_neighbour,
     [](WindowState& s, bool) { select(s, 1); }},  // AZERTY, no Shift
    {Key::v, 0, "V", &W::does_vectors, [](WindowState& s, bool) { s.sight.vectors = !s.sight.vectors; }},
    {Key::e, 0, "E", &W::does_plots, [](WindowState& s, bool) { s.sight.plots = !s.sight.plots; }},
    {Key::b, 0, "B", &W::does_sides, [](WindowState& s, bool) { s.toggle_sides(); }},
    {Key::tab, 0, "Tab", &W::does_panel, [](WindowState& s, bool) { s.panel = !s.panel; }},
    {Key::home, 0, "Home", &W::does_view, [](WindowState& s, bool) { s.sight.show_whole_scene(); }},
    {Key::f5, 0, "F5", &W::does_save, [](WindowState& s, bool) { s.save(); }},
    {Key::f9, 0, "F9", &W::does_restore, [](WindowState& s, bool) { s.restore(); }},
    {Key::f10, 0, "F10", &W::does_video, [](WindowState& s, bool) { s.toggle_video(); }},
    {Key::f12, 0, "F12", &W::does_picture, [](WindowState& s, bool) { s.picture_wanted = true; }},
    {Key::f3, 0, "F3", &W::does_theme, [](WindowState&, bool) { other_theme(); }},
    {Key::f4, 0, "F4", &W::does_letters, [](WindowState& s, bool) { s.next_scale(); }},
    {Key::f1, 0, "F1", &W::does_help, [](WindowState& s, bool) { s.help = !s.help; }},
    {Key::h, 0, "H", &W::does_help, [](WindowState& s, bool) { s.help = !s.help; }},
    {Key::f2, 0, "F2", &W::does_language, switch_language},
    {Key::escape, 0, "Esc", &W::does_quit, escape},
}};

}  // namespace

std::span<const Shortcut> shortcuts() { return table; }

void press(WindowState& state, const Input& input) {
  if (input.control || input.alt) return;
  for (const auto& shortcut : table) {
    const bool by_key =
        input.kind == Input::Kind::key_down && shortcut.key != Key::other && input.key == shortcut.key;
    const bool by_character = input.kind == Input::Kind::character && shortcut.character != 0 &&
                              input.character == shortcut.character;
    if (!by_key && !by_character) continue;
    if (!input.repeat || shortcut.repeats) shortcut.act(state, input.shift);
    return;
  }
}

}  // namespace clapotis
