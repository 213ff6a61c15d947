#include "stage5_extensions/scenes.hpp"
#include "tests/catch.hpp"
#include "tests/stage4/state.hpp"

using namespace clapotis;
using namespace clapotis::tests;

TEST_CASE("water between plates follows the series solution within 2 % of its final speed", "[stage5]") {
  const std::string name = GENERATE("poiseuille", "couette");
  Simulation channel(stage5::stage().scene(name), {});
  for (const double t : {0.0225, 0.045, 0.1125, 0.225}) {  // Morris, Fox & Zhu 1997
    run_until(channel, t);
    CAPTURE(name, t);
    CHECK(channel.error() < 0.02);
  }
}
