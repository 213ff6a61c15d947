#pragma once

#include "common/runner/canvas.hpp"

struct ImVec4;

/// The light, restrained look of the window: one place for colours and sizes.
namespace clapotis::theme {

/// Height of a line [pixel] at scale 1, ascenders to descenders: the letters are those of a 16 pixel font.
constexpr double font_size = 19;

constexpr Colour panel{0.945f, 0.950f, 0.955f};  ///< behind the controls
constexpr Colour ink{0.12f, 0.14f, 0.17f};
constexpr Colour faint{0.38f, 0.42f, 0.47f};  ///< secondary text, still 5:1 against the panel
constexpr Colour accent{0.10f, 0.37f, 0.60f};
constexpr Colour caution{0.60f, 0.36f, 0.00f};  ///< amber, dark enough to be read on the panel
constexpr Colour warning{0.72f, 0.20f, 0.08f};

ImVec4 vec(Colour colour);  ///< as ImGui has it

/// While it lives, text is bold.
class Bold {
 public:
  Bold();
  ~Bold();
  Bold(const Bold&) = delete;
  Bold& operator=(const Bold&) = delete;
};

/// While it lives, buttons are those that matter most: white on the accent.
class Main {
 public:
  Main();
  ~Main();
  Main(const Main&) = delete;
  Main& operator=(const Main&) = delete;
};

/// Gives ImGui these colours and distances that grow with `scale`.
void apply(double scale);

}  // namespace clapotis::theme
