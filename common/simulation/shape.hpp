#pragma once

namespace clapotis {

/// What points that are drawn over a scene are.
enum class Shape {
  particles,  ///< where each particle should be
  outline,    ///< of all of them: one closed line
  lines,      ///< open lines, for example a free surface; a point that is no number begins another one
  marks       ///< places, each with a label; one that is no number is not there now
};

}  // namespace clapotis
