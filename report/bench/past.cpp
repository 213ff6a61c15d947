#include <fmt/core.h>

#include <algorithm>

#include "common/runner/stopwatch.hpp"
#include "common/window/past.hpp"
#include "report/bench/timed.hpp"
#include "stage3_grid/scenes.hpp"
#include "stage4_sph/scenes.hpp"

namespace clapotis::bench {
namespace {

/// One step a frame, as in a scene that is slower than real time: the greatest share that a moment can have.
void measure(const Scene& scene, const Overrides& parameters) {
  constexpr int frames = 200;
  Simulation simulation(scene, parameters);
  const std::array present{&simulation};
  Past past;
  past.begin(present);
  double stepping = 0, keeping = 0, returning = 0;
  for (int frame = 0; frame < frames; ++frame) {
    const double start = wall_seconds();
    simulation.step();
    const double stepped = wall_seconds();
    past.keep(present, stepped - start);
    stepping += stepped - start;
    keeping += wall_seconds() - stepped;
  }
  const auto kept = past.size(), bytes = past.bytes();
  for (long step = past.newest().step; step > past.oldest().step; --step) {
    const double start = wall_seconds();
    past.restore(present, step);
    returning = std::max(returning, wall_seconds() - start);
  }
  fmt::print(
      "{:>10} {:>6} particles: {:.0f} bytes a moment, {:.3f} ms to keep it, {:.1f} % of one step ({:.2f} "
      "ms); "
      "at most {:.2f} ms to return to one\n",
      scene.name, simulation.particles().size(), static_cast<double>(bytes) / static_cast<double>(kept),
      1e3 * keeping / frames, 100 * keeping / stepping, 1e3 * stepping / frames, 1e3 * returning);
}

}  // namespace

TEST_CASE("what it costs to remember a moment", "[past]") {
  const auto side = [](double particles) { return to_text(std::ceil(40 * std::sqrt(particles))); };
  for (const int n : {500, 20000})
    measure(stage3::stage().scene("cloud"),
            {{"particles", {std::to_string(n)}}, {"width", {side(n)}}, {"height", {side(n)}}});
  for (const char* spacing : {"0.0632", "0.01"})
    measure(stage4::stage().scene("dam_break"), {{"spacing", {spacing}}});
}

}  // namespace clapotis::bench
