#pragma once

#include <optional>
#include <string>

#include "common/window/controls.hpp"
#include "common/window/typed_text.hpp"

namespace clapotis {

/// One row of the panel per parameter of the scene's table: symbol and unit, a slider (or a list, or a text
/// field after Ctrl-click), the allowed values. A live parameter acts while it is dragged, the others when
/// they are let go.
class ParameterRows {
 public:
  enum class Group { live, time_step, restart, stepped };
  static Group group_of(const Parameter& parameter);

  /// The rows of the first three groups.
  void lay_out(WindowState& state, Controls& controls, Group group);
  /// The whole numbers without a natural end, such as the seed, with - and + in the place of a slider. The
  /// field begins at `start` and is `width` pixels wide.
  void steppers(WindowState& state, Controls& controls, float start, float width);

 private:
  struct Wanted {
    std::string name, text;
  };
  struct Dragged {
    std::string name;
    double value;
  };

  void row(WindowState& state, Controls& controls, const Parameter& parameter);
  void field(WindowState& state, const Parameter& parameter, float width);
  void slider(WindowState& state, const Parameter& parameter);
  void choice(WindowState& state, const Parameter& parameter);
  void automatic(WindowState& state, const Parameter& parameter);
  void type(WindowState& state, const Parameter& parameter);
  void text_button(WindowState& state, const Parameter& parameter, float width);
  void text_field(WindowState& state, const Parameter& parameter);
  void apply(WindowState& state);
  void tooltip(const Parameter& parameter) const;

  TypedText text_;
  double still_ = 0;                ///< for how long the mouse has been at rest [s]
  std::optional<Wanted> wanted_;    ///< what the user asked for in this frame
  std::optional<Dragged> dragged_;  ///< the value of a slider that acts when it is let go
};

}  // namespace clapotis
