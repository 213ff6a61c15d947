#include <fmt/core.h>

#include <algorithm>
#include <string>
#include <vector>

#include "common/runner/stopwatch.hpp"
#include "report/bench/timed.hpp"
#include "tests/window/desk.hpp"

namespace clapotis::bench {
namespace {

constexpr int presses = 40;

/// From the key on a private X server to the first frame after the one that shows what it did, which is when
/// the window says so: one frame more than a user waits for.
std::vector<double> answers(testing::Desk& desk) {
  std::vector<double> seconds;
  for (int k = 0; k < presses; ++k) {
    const double start = wall_seconds();
    desk.key("v");
    desk.await(k % 2 == 0 ? "velocities on" : "velocities off");
    seconds.push_back(wall_seconds() - start);
  }
  std::ranges::sort(seconds);
  return seconds;
}

void measure(const std::string& what, const std::vector<std::string>& command) {
  testing::Desk desk("latency");
  desk.start(command);
  desk.await("velocities off");
  const auto seconds = answers(desk);
  fmt::print("{}: a key is answered within {:.0f} ms (median), {:.0f} ms (all but one in twenty)\n", what,
             1e3 * seconds[presses / 2], 1e3 * seconds[presses - presses / 20]);
}

}  // namespace

TEST_CASE("how long a key waits for its answer, while the scene runs", "[latency]") {
  measure("2,048 particles of a dam break", {STAGE4_PROGRAM, "dam_break"});
  measure("20,000 particles", {STAGE4_PROGRAM, "dam_break", "--set", "spacing=0.01"});
  measure("20,000 particles, paused", {STAGE4_PROGRAM, "dam_break", "--set", "spacing=0.01", "--paused"});
}

}  // namespace clapotis::bench
