#pragma once

#include "common/runner/picture.hpp"

namespace clapotis {

/// What a picture's reference has, painted over its scene, and in a corner of the scene what it is and how
/// far the run is from it.
void paint_reference(Canvas& canvas, const Picture& picture, const PictureView& view);

}  // namespace clapotis
