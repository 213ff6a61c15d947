#pragma once

#include <optional>
#include <string>
#include <vector>

#include "common/runner/canvas.hpp"
#include "common/window/controls.hpp"
#include "common/window/lesson_tab.hpp"
#include "common/window/parameter_rows.hpp"
#include "common/window/sides_section.hpp"
#include "common/window/window_state.hpp"

namespace clapotis {

/// The right part of the window: what can be set, and what the run costs.
class Panel {
 public:
  explicit Panel(Controls& controls) : controls_(controls), lesson_(controls) {}
  void lay_out(WindowState& state, const Box& area);

 private:
  void transport(WindowState& state);
  void speed(WindowState& state);
  void scene(WindowState& state);
  void preset(WindowState& state);
  void parameters(WindowState& state);
  void time_step(WindowState& state);
  void view(WindowState& state);
  void look(WindowState& state);
  void mouse(WindowState& state);
  void record(WindowState& state);
  void cost(WindowState& state);
  /// A list to choose from; the place of the one that was chosen now. `share` of the panel's width.
  std::optional<std::size_t> list(WindowState& state, const std::string& name, std::string_view label,
                                  const std::vector<std::string>& names, const std::string& present,
                                  float share = 0.74F);

  Controls& controls_;
  ParameterRows rows_;
  SidesSection sides_;
  LessonTab lesson_;
};

}  // namespace clapotis
