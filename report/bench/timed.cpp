#include "report/bench/timed.hpp"

#include <algorithm>
#include <vector>

#include "common/runner/stopwatch.hpp"
#include "report/in_turns.hpp"

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
  return median_of(in_turns(base, other, 31, 20, wall_seconds),
                   [](const Turn& turn) { return turn.base / turn.other; });
}

}  // namespace clapotis::bench
