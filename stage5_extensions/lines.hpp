#pragma once

#include "common/simulation/system.hpp"

/// Lines that a reference draws over a scene.
namespace clapotis::stage5 {

/// The line y = height(x) for 0 <= x <= width.
template <class Height>
Vectors curve(double width, const Height& height, Index points = 97) {
  Vectors line(points, 2);
  for (Index k = 0; k < points; ++k) {
    const double x = width * static_cast<double>(k) / static_cast<double>(points - 1);
    line.row(k) << x, height(x);
  }
  return line;
}

/// The same line with x and y in each other's place.
Vectors upright(Vectors line);

/// Two lines that do not meet.
Vectors both(const Vectors& first, const Vectors& second);

/// The velocity along x of each particle not farther than `near` from x: as a profile is drawn, the point
/// that is `scale` times it to the right of x, at the particle's height.
Vectors velocity_profile(const System& s, double x, double near, double scale);

}  // namespace clapotis::stage5
