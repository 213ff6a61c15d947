#include "common/window/window_state.hpp"

#include <algorithm>

#include "common/runner/particle_table.hpp"
#include "common/runner/vtk_files.hpp"
#include "common/words.hpp"

namespace clapotis {
namespace {

constexpr double notice_seconds = 6;

std::string about_file(std::string_view sentence, const std::string& file) {
  return say(sentence, fmt::arg("file", file));
}

}  // namespace

void WindowState::next_scale() {
  const auto larger = std::ranges::upper_bound(scales, scale + 1e-9);
  scale = larger == scales.end() ? scales.front() : *larger;
}

void WindowState::step_back(bool ten) {
  attempt([&] { session.step_back(ten ? 10 : 1); });
  if (session.sides() != nullptr) return;
  const auto oldest = session.past().oldest();
  if (session.simulation().steps() > oldest.step) return;
  const auto time = fmt::arg("time", fmt::format("{:.4g}", oldest.time));
  notice = {say(words().window.past.oldest, time), false, notice_seconds};
}

void WindowState::save() {
  attempt([&] {
    notice = {about_file(words().window.state_saved, recorder.save(session)), false, notice_seconds};
  });
}

void WindowState::restore() {
  attempt([&] {
    recorder.restore(session);
    notice = {about_file(words().window.state_restored, recorder.saved().filename().string()), false,
              notice_seconds};
  });
}

void WindowState::write_table() {
  attempt([&] {
    const auto file = free_name(session, ".csv");
    write_particles(file, session.simulation());
    notice = {about_file(words().window.picture_saved, file.string()), false, notice_seconds};
  });
}

void WindowState::write_grid() {
  attempt([&] {
    const auto file = free_name(session, ".vtu");
    write_vtu(file, session.simulation());
    notice = {about_file(words().window.picture_saved, file.string()), false, notice_seconds};
  });
}

void WindowState::toggle_sides() {
  attempt([&] {
    session.toggle_side_by_side();
    const auto& w = words().window.sides;
    const auto* sides = session.sides();
    notice = {sides != nullptr ? say(w.started, fmt::arg("left", sides->left().text),
                                     fmt::arg("right", sides->right().text))
                               : std::string(w.ended),
              false, notice_seconds};
  });
}

void WindowState::toggle_video() {
  attempt([&] {
    if (!recorder.recording()) {
      recorder.begin(session);
    } else {
      notice = {about_file(words().window.picture_saved, recorder.end()), false, notice_seconds};
    }
  });
}

}  // namespace clapotis
