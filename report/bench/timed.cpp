#include "report/bench/timed.hpp"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <vector>

namespace clapotis::bench {
namespace {

double last_median = 0;

#if __has_include(<catch2/catch_all.hpp>)
using ListenerBase = Catch::EventListenerBase;
#else
using ListenerBase = Catch::TestEventListenerBase;
#endif

/// Catch2 tells what it measured only to listeners.
struct Median : ListenerBase {
  using ListenerBase::ListenerBase;
  void benchmarkEnded(const Catch::BenchmarkStats<>& stats) override {
    std::vector<double> seconds;
    for (const auto& sample : stats.samples) seconds.push_back(sample.count() * 1e-9);
    std::nth_element(seconds.begin(), seconds.begin() + static_cast<long>(seconds.size() / 2), seconds.end());
    last_median = seconds[seconds.size() / 2];
  }
};
CATCH_REGISTER_LISTENER(Median)

}  // namespace

double median_seconds(const std::string& name, const std::function<void()>& act) {
  BENCHMARK(std::string(name)) { act(); };
  return last_median;
}

double step_seconds(const std::string& name, Simulation& simulation) {
  return median_seconds(name, [&] { simulation.step(); });
}

double times_as_fast(Simulation& other, Simulation& base) {
  constexpr int turns = 31, steps = 20;
  const auto seconds = [](Simulation& simulation) {
    const auto start = std::chrono::steady_clock::now();
    for (int step = 0; step < steps; ++step) simulation.step();
    return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  };
  std::vector<double> ratios;
  for (int turn = 0; turn < turns; ++turn) {
    const double before = seconds(base);
    ratios.push_back(before / seconds(other));
  }
  std::nth_element(ratios.begin(), ratios.begin() + turns / 2, ratios.end());
  return ratios[turns / 2];
}

std::unique_ptr<Simulation> packed_cloud(const Stage& stage, long count, int threads) {
  constexpr double h = 10;
  const auto across = static_cast<long>(std::ceil(std::sqrt(static_cast<double>(count) * std::sqrt(0.75))));
  const long lines = (count + across - 1) / across;
  const double width = 2 * h * (static_cast<double>(across) + 0.5);
  const double height = 2 * h * (static_cast<double>(lines - 1) * std::sqrt(0.75) + 1.001);
  const Overrides overrides{{"particles", {std::to_string(count)}},
                            {"width", {to_text(width)}},
                            {"height", {to_text(height)}},
                            {"y0", {"0"}}};
  auto simulation =
      std::make_unique<Simulation>(stage.scene("cloud"), overrides, default_integrator, threads);
  simulation->system().position *= 0.99;
  simulation->step();
  return simulation;
}

}  // namespace clapotis::bench
