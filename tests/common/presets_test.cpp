#include <string>

#include "stage1_bouncing/scenes.hpp"
#include "stage3_grid/scenes.hpp"
#include "stage4_sph/scenes.hpp"
#include "stage5_extensions/scenes.hpp"
#include "tests/catch.hpp"
#include "tests/common/programs.hpp"
#include "tests/stage4/state.hpp"

// Sets of values that come with a scene, and what pictures are coloured by.

using namespace clapotis;
using namespace clapotis::testing;
using Catch::Matchers::ContainsSubstring;

TEST_CASE("every preset of every scene is a run that steps", "[runner]") {
  for (const auto& stage : {stage1::stage(), stage3::stage(), stage4::stage(), stage5::stage()})
    for (const auto& scene : stage.scenes)
      for (const auto& preset : scene.presets) {
        CAPTURE(stage.name, scene.name, preset.name);
        Simulation simulation(scene, scene.preset(preset.name, Origin::flag));
        for (int k = 0; k < 3; ++k) simulation.step();
        CHECK(simulation.particles().finite());
        for (const auto& [name, text] : preset.values)
          CHECK(simulation.parameters().find(name)->text() == text);
      }
}

TEST_CASE("a preset counts more than the scene, and less than --set", "[runner]") {
  const Scratch scratch;
  const auto moon = run(scratch, stage1, {"--preset", "moon", "--set", "drag=0.5", "--print-config"});
  require_done(moon);
  CHECK_THAT(moon.out, ContainsSubstring("gravity") && ContainsSubstring("83"));
  CHECK_THAT(moon.out, ContainsSubstring("0.5"));
  const auto list = run(scratch, stage1, {"--list", "presets"});
  require_done(list);
  CHECK_THAT(list.out, ContainsSubstring("moon") && ContainsSubstring("gravity=83"));
  const auto wrong = run(scratch, stage1, {"--headless", "--preset", "mon"});
  CHECK(wrong.code == 2);
  CHECK_THAT(wrong.err, ContainsSubstring("did you mean moon?"));
}

TEST_CASE("pictures can be coloured by any quantity that the scene has", "[runner]") {
  const Scratch scratch;
  const auto by = [&](const std::string& name) {
    return run(scratch, stage4, {"elliptical_drop", "--headless", "--steps", "2", "--set", "spacing=0.2",
                                 "--colour-by", name, "--out", (scratch / name).string()});
  };
  for (const std::string name : {"vorticity", "pressure", "density", "plain"}) {
    CAPTURE(name);
    require_done(by(name));
    CHECK(std::filesystem::exists(scratch / name / "picture.png"));
  }
  const auto wrong = by("vortex");
  CHECK(wrong.code == 2);
  CHECK_THAT(wrong.err, ContainsSubstring("vorticity"));
  CHECK_FALSE(std::filesystem::exists(scratch / "vortex"));
}

TEST_CASE("vorticity is what a body turns with, twice its rate", "[stage4]") {
  Simulation patch(stage4::stage().scene("square_patch"), {{"spacing", {"0.05"}}});
  const Column curl = patch.model().vorticity(patch.particles());
  for (Index i = 0; i < curl.size(); ++i) {
    const Vector r = row(patch.particles().position, i);
    if (std::abs(r.x) < 0.3 && std::abs(r.y) < 0.3)  // away from the surface, where neighbours are missing
      CHECK(curl(i) == Approx(-2).epsilon(0.02));    // v = omega (y, -x), omega = 1
  }
}
