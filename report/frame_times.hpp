#pragma once

namespace clapotis {

/// Medians of a frame of the cloud of stage 3, 1280 x 720: our own processor time, and from one frame to the
/// next [s].
struct FrameTimes {
  double ours, whole;
};

/// Needs a display.
FrameTimes frame_times(long discs, int frames);

}  // namespace clapotis
