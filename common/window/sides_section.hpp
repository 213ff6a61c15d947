#pragma once

#include "common/window/controls.hpp"
#include "common/window/typed_text.hpp"

namespace clapotis {

/// In the panel: whether the scene runs twice, what the two sides differ in, and what the right one has.
class SidesSection {
 public:
  /// A button in what is left of the present row, and, with two sides, a row below it.
  void lay_out(WindowState& state, Controls& controls);

 private:
  void contrast(WindowState& state, Controls& controls);
  void other_value(WindowState& state, Controls& controls, float width);
  void type(WindowState& state, Controls& controls, float width);

  TypedText text_;
};

}  // namespace clapotis
