#include <fmt/core.h>

#include <algorithm>

#include "common/runner/stopwatch.hpp"
#include "common/window/past.hpp"
#include "report/bench/timed.hpp"
#include "stage3_grid/scenes.hpp"
#include "stage4_sph/scenes.hpp"

namespace clapotis::bench {
namespace {

void measure(const Scene& scene, const Overrides& parameters) {
  Simulation simulation(scene, parameters);
  const std::array present{&simulation};
  Past past({.bytes = std::size_t{30} << 20});  // it soon writes over what it wrote before
  past.begin(present);
  const auto share_of = [&](double seconds) {
    double stepping = 0, keeping = 0;
    while (stepping < seconds) {
      const double start = wall_seconds();
      simulation.step();
      const double stepped = wall_seconds();
      past.pass(present, stepped - start);
      stepping += stepped - start;
      keeping += wall_seconds() - stepped;
    }
    return 100 * keeping / stepping;
  };
  const double at_first = share_of(2), then = share_of(2);
  double returning = 0;
  const auto kept = past.size(), bytes = past.bytes();
  for (long step = past.newest().step; step > past.oldest().step; step = past.before(step).step - 1) {
    const double start = wall_seconds();
    past.restore(present, step);
    returning = std::max(returning, wall_seconds() - start);
  }
  fmt::print(
      "{:>10} {:>6} particles: {:.0f} bytes a moment, {} of them, {:.1f} % of the work, then {:.1f} %, to "
      "keep them; {:.2f} "
      "ms to return to one\n",
      scene.name, simulation.particles().size(), static_cast<double>(bytes) / static_cast<double>(kept), kept,
      at_first, then, 1e3 * returning);
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
