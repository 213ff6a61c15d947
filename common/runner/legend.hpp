#pragma once

#include "common/runner/picture.hpp"

namespace clapotis {

// What stands around the scene of a picture, never over it. (Over it there is only what its reference says.)

[[nodiscard]] bool has_legend(const Picture& picture);
[[nodiscard]] double header_height(double width, double scale, bool has_colours);
[[nodiscard]] double footer_height(double scale);

/// Title, subtitle and the colour bar.
void paint_header(Canvas& canvas, const Picture& picture, const PictureView& view);

/// The same above two pictures side by side, with the colours of one of them.
void paint_common_header(Canvas& canvas, const std::string& title, const std::string& subtitle,
                         const Picture& picture, const PictureView& view);

/// Ruler, what the marks mean.
void paint_footer(Canvas& canvas, const Picture& picture, const PictureView& view);

}  // namespace clapotis
