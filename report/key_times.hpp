#pragma once

#include <string>
#include <vector>

namespace clapotis {

/// How long keys wait for the frame that shows what they did [s], sorted: from when the program that sends
/// the key has ended, which is too late, and from when it was started, which is too early. Both have the
/// frame more that the window's own word takes.
struct KeyTimes {
  std::vector<double> at_least, at_most;
};

/// Of so many presses of a key in the window of `command`, on a private X server.
KeyTimes key_times(const std::vector<std::string>& command, int presses);

}  // namespace clapotis
