#include <cmath>
#include <numbers>
#include <vector>

#include "common/references/waves.hpp"
#include "stage5_extensions/scenes.hpp"
#include "tests/catch.hpp"
#include "tests/stage4/state.hpp"

using namespace clapotis;
using namespace clapotis::tests;
using std::numbers::pi;

namespace {

constexpr double k = 2 * pi;  // of a wave as long as the tank, 1 m, on water as deep

struct Extreme {
  double time, height;
};

/// The first `count` extremes of the wave after the start, each the top of the parabola through three steps.
std::vector<Extreme> extremes(Simulation& wave, std::size_t count) {
  std::vector<Extreme> all;
  Extreme before{}, last{wave.time(), measure(wave, "wave_amplitude")};
  while (all.size() < count) {
    wave.step();
    const Extreme now{wave.time(), measure(wave, "wave_amplitude")};
    if (before.time > 0 && (last.height - before.height) * (now.height - last.height) < 0) {
      const double s = (last.height - before.height) / (last.time - before.time),
                   f = (now.height - last.height) / (now.time - last.time);
      const double top = (before.time + last.time) / 2 + s / (s - f) * (now.time - before.time) / 2;
      all.push_back({top, last.height});
    }
    before = last;
    last = now;
  }
  return all;
}

}  // namespace

TEST_CASE("a standing wave without viscosity swings with the frequency of linear theory within 1 %",
          "[stage5]") {
  Simulation wave(stage5::stage().scene("standing_wave"), {});
  const auto tops = extremes(wave, 3);  // at T/2, T, 3T/2
  CHECK(2 * pi / (tops[2].time - tops[0].time) == Approx(wave_frequency(9.81, k, 1)).epsilon(0.01));
}

TEST_CASE("a viscous standing wave swings and decays as Lamb's equation says, within 10 %", "[stage5]") {
  const double reynolds = GENERATE(100, 500);
  const double nu = std::sqrt(9.81) / reynolds;
  Simulation wave(stage5::stage().scene("standing_wave"), {{"nu", {to_text(nu)}}});
  // The start is at rest, which the decaying wave of the equation never is: it counts from the first half
  // swing on.
  const auto tops = extremes(wave, 3);
  const auto exact = viscous_wave(9.81, k, nu);
  const double period = tops[2].time - tops[0].time;
  CAPTURE(reynolds, period, tops[0].height, tops[2].height);
  CHECK(2 * pi / period == Approx(exact.frequency).epsilon(reynolds < 200 ? 0.02 : 0.01));
  // One swing over the one before, which does not see the few tenths of a millimetre by which the lattice
  // settles.
  const double half = (tops[1].height - tops[2].height) / (tops[1].height - tops[0].height);
  CHECK(-std::log(half) / (period / 2) == Approx(exact.decay).epsilon(0.1));
}

TEST_CASE("water in a tank that begins to sway follows linear theory for two natural periods within a tenth",
          "[stage5]") {
  Simulation tank(stage5::stage().scene("sloshing"), {});
  const SwayedTank exact{1, 0.5, 9.81, 0.01, 2 * pi / 1.5};
  double most = 0, worst = 0;
  while (tank.time() < 2 * 1.18182) {
    tank.step();
    most = std::max(most, std::abs(exact.elevation(0, tank.time())));
    worst = std::max(worst, tank.error() * 0.01);
  }
  CAPTURE(most, worst);
  CHECK(worst < 0.1 * most);
}

TEST_CASE("what a swaying tank puts into its water is in the budget of energy", "[stage5]") {
  Simulation tank(stage5::stage().scene("sloshing"), {{"spacing", {"0.05"}}, {"amplitude", {"0.02"}}});
  const double start = tank.energy().total(), calm = tank.energy().mechanical();
  double swing = 0;
  while (tank.time() < 1.5) {
    tank.step();
    swing = std::max(swing, tank.energy().mechanical() - calm);
  }
  CAPTURE(swing);
  CHECK(swing > 0.1);
  CHECK(std::abs(tank.energy().total() - start) < 0.01 * swing);
}
