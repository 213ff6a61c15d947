#include <cstring>
#include <string>

#include "stage4_sph/scenes.hpp"
#include "tests/catch.hpp"
#include "tests/stage4/state.hpp"

using namespace clapotis;
using namespace clapotis::tests;

TEST_CASE("any number of threads computes the same dam break, bit for bit", "[stage4]") {
  const std::string density = GENERATE("continuity", "summation");
  const Scene scene = stage4::stage().scene("dam_break");
  // more particles than the blocks that sums are cut into, so that there are several
  const auto values = typed({{"spacing", 0.02}, {"density", density}});
  Simulation one(scene, values);
  REQUIRE(one.particles().size() > block_size);
  run_steps(one, 50);
  for (const int threads : {2, 3}) {
    Simulation several(scene, values, default_integrator, threads);
    run_steps(several, 50);
    CAPTURE(density, threads);
    CHECK(same_fluid(one, several));
    CHECK(several.energy().total() == one.energy().total());
  }
}
