#include <fmt/core.h>

#include "common/window/display.hpp"
#include "report/bench/timed.hpp"
#include "report/frame_times.hpp"

namespace clapotis::bench {

TEST_CASE("drawing the cloud of stage 3: our own processor time per frame", "[drawing]") {
  if (!display_available()) {
    fmt::print("no display: nothing drawn\n");
    return;
  }
  for (const long discs : {500, 5000, 20000}) {
    const auto frame = frame_times(discs, 120);
    fmt::print(
        "{:>6} discs: {:.2f} ms of our own processor time per frame, {:.0f} frames per second (at most 60)\n",
        discs, 1e3 * frame.ours, 1 / frame.whole);
  }
}

}  // namespace clapotis::bench
