#include <fmt/core.h>

#include <string>
#include <vector>

#include "report/bench/timed.hpp"
#include "report/key_times.hpp"

namespace clapotis::bench {
namespace {

void measure(const std::string& what, const std::vector<std::string>& command) {
  constexpr int presses = 40;
  const auto times = key_times(command, presses);
  fmt::print("{}: a key is answered within {:.0f} to {:.0f} ms (median), {:.0f} ms (all but one in twenty)\n",
             what, 1e3 * times.at_least[presses / 2], 1e3 * times.at_most[presses / 2],
             1e3 * times.at_most[presses - presses / 20]);
}

}  // namespace

TEST_CASE("how long a key waits for its answer, while the scene runs", "[latency]") {
  measure("2,048 particles of a dam break", {STAGE4_PROGRAM, "dam_break"});
  measure("20,000 particles", {STAGE4_PROGRAM, "dam_break", "--set", "spacing=0.01"});
  measure("20,000 particles, paused", {STAGE4_PROGRAM, "dam_break", "--set", "spacing=0.01", "--paused"});
}

}  // namespace clapotis::bench
