#pragma once

#include <string>
#include <string_view>

#include "common/window/controls.hpp"
#include "common/window/window_state.hpp"

namespace clapotis {

/// The tab of the panel in which a class goes through the exercises of the stage: what is asked, runs that
/// set the scene, and the answer, which is hidden until asked and checked against the runs.
class LessonTab {
 public:
  explicit LessonTab(Controls& controls) : controls_(controls) {}
  /// The bar of tabs, and below it the lesson where that is chosen; false where the scene is.
  bool lay_out(WindowState& state);

 private:
  void pages(LessonPlay& lesson);
  void run(WindowState& state, std::size_t number);
  void check(const LessonPlay& lesson, std::size_t number);

  Controls& controls_;
  bool scroll_to_answer_ = false;
};

}  // namespace clapotis
