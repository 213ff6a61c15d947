#pragma once

#include <algorithm>
#include <chrono>
#include <vector>

namespace clapotis {

/// Adds the seconds until it goes to `total`, if it is asked to.
class PhaseTimer {
 public:
  PhaseTimer(bool timed, double& total) : total_(timed ? &total : nullptr) {
    if (timed) start_ = std::chrono::steady_clock::now();
  }
  PhaseTimer(const PhaseTimer&) = delete;
  PhaseTimer& operator=(const PhaseTimer&) = delete;
  ~PhaseTimer() {
    if (total_ != nullptr)
      *total_ += std::chrono::duration<double>(std::chrono::steady_clock::now() - start_).count();
  }

 private:
  double* total_;
  std::chrono::steady_clock::time_point start_;
};

/// Median seconds of `repetitions` calls.
template <class Act>
double median_seconds_of(int repetitions, const Act& act) {
  std::vector<double> seconds(static_cast<std::size_t>(repetitions), 0);
  for (double& one : seconds) {
    const PhaseTimer timer(true, one);
    act();
  }
  const auto middle = seconds.begin() + repetitions / 2;
  std::nth_element(seconds.begin(), middle, seconds.end());
  return *middle;
}

}  // namespace clapotis
