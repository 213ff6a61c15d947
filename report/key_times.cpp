#include "report/key_times.hpp"

#include <algorithm>

#include "common/runner/stopwatch.hpp"
#include "tests/window/desk.hpp"

namespace clapotis {

KeyTimes key_times(const std::vector<std::string>& command, int presses) {
  testing::Desk desk("key-times");
  desk.start(command);
  desk.await("velocities off");
  KeyTimes times;
  for (int k = 0; k < presses; ++k) {
    const double start = wall_seconds();
    desk.key("v");
    const double sent = wall_seconds();
    desk.await(k % 2 == 0 ? "velocities on" : "velocities off");
    const double answered = wall_seconds();
    times.at_least.push_back(answered - sent);
    times.at_most.push_back(answered - start);
  }
  std::ranges::sort(times.at_least);
  std::ranges::sort(times.at_most);
  return times;
}

}  // namespace clapotis
