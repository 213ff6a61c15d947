#pragma once

#include "common/runner/picture.hpp"

namespace clapotis {

// What stands around the scene of a picture, never over it. (Over it there is only what its reference says.)

[[nodiscard]] double header_height(double width, double scale, bool has_colours);
[[nodiscard]] double footer_height(double scale);

/// Title, subtitle and the colour bar.
void paint_header(Canvas& canvas, const Picture& picture, const PictureView& view);

/// Ruler, what the marks mean.
void paint_footer(Canvas& canvas, const Picture& picture, const PictureView& view);

}  // namespace clapotis
