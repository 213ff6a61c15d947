#pragma once

#include "common/runner/canvas.hpp"

/// The light, restrained look of the window: one place for colours and sizes.
namespace clapotis::theme {

constexpr double font_size = 17;  ///< [pixel] at scale 1

constexpr Colour paper{0.985f, 0.985f, 0.98f};   ///< behind the scene
constexpr Colour panel{0.945f, 0.950f, 0.955f};  ///< behind the controls
constexpr Colour ink{0.12f, 0.14f, 0.17f};
constexpr Colour faint{0.38f, 0.42f, 0.47f};  ///< secondary text, still 5:1 against the panel
constexpr Colour accent{0.10f, 0.37f, 0.60f};
constexpr Colour warning{0.72f, 0.20f, 0.08f};

/// Gives ImGui these colours and distances that grow with `scale`.
void apply(double scale);

}  // namespace clapotis::theme
