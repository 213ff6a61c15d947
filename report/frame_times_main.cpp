#include <fmt/core.h>

#include <cstdlib>

#include "report/frame_times.hpp"

/// frame_times DISCS FRAMES: prints the two medians of `FrameTimes` [s]. A program of its own, because SFML
/// ends the one whose X server goes away.
int main(int argc, char** argv) {
  if (argc != 3) return 2;
  const auto times = clapotis::frame_times(std::atol(argv[1]), std::atoi(argv[2]));
  fmt::print("{} {}\n", times.ours, times.whole);
}
