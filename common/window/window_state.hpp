#pragma once

#include <array>
#include <optional>
#include <string>

#include "common/simulation/errors.hpp"
#include "common/window/cost_meter.hpp"
#include "common/window/lesson_play.hpp"
#include "common/window/recorder.hpp"
#include "common/window/session.hpp"
#include "common/window/sight.hpp"

namespace clapotis {

/// A sentence for the user that goes away by itself.
struct Notice {
  std::string text;
  bool refusal = false;
  double seconds_left = 0;
};

/// What the left mouse button does: looks at a particle, or acts on a liquid that has a hand.
enum class Tool { probe, pull, push, add, erase, obstacle, grab };
inline constexpr std::array<const char*, 7> tool_names{"probe", "pull",     "push", "add",
                                                       "erase", "obstacle", "grab"};
inline std::string tool_name(Tool tool) { return tool_names[static_cast<std::size_t>(tool)]; }
/// How far it reaches around the mouse; 0 where it acts on a point or on the whole tank [L].
[[nodiscard]] double brush_radius(const Simulation& simulation, Tool tool);

/// How large letters and lines can be made while the window is open; 1 suits 1280 x 720.
inline constexpr std::array<double, 5> scales{1, 1.25, 1.5, 1.75, 2};

/// All that the user of the window can change, and what every part of it reads.
struct WindowState {
  Session session;
  LessonPlay lesson;
  Sight sight{};
  CostMeter cost{};
  Recorder recorder{};
  Notice notice{};
  bool panel = true, help = false;
  bool lesson_shown = false;  ///< the panel's tab
  bool picture_wanted = false, quit = false;
  bool menu_open = false;   ///< a list of the panel is open
  bool close_menu = false;  ///< ... and Esc was pressed
  std::string typing{};     ///< the parameter whose value is being typed
  double scale = 1;
  Tool tool = Tool::probe;
  std::optional<Point> mouse{};  ///< where it is in the window [pixel]

  void next_scale();         ///< of letters and lines, after the last of `scales` the first
  void step_back(bool ten);  ///< and says so where nothing older is kept
  void save();               ///< the state, and says where
  void restore();            ///< the state saved last
  void write_table();        ///< of all particles as they stand, and says where
  void write_grid();         ///< the same for ParaView
  void toggle_sides();       ///< two sides, which start anew, or the left one alone
  void toggle_video();       ///< begins one, or ends it and says where it is

  /// Does what the user asked for; what cannot be done is said instead.
  template <class Action>
  void attempt(const Action& action) {
    try {
      action();
    } catch (const BadInput& refusal) {
      notice = {refusal.what(), true, 10};
    } catch (const FileError& failure) {
      notice = {failure.what(), true, 10};
    }
  }
};

}  // namespace clapotis
