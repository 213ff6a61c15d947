#pragma once

#include "common/runner/stopwatch.hpp"

namespace clapotis {

/// Adds the processor time of its own life to a sum [s], also when a step throws.
class Timing {
 public:
  explicit Timing(double& sum) : sum_(sum) {}
  ~Timing() { sum_ += processor_seconds() - start_; }
  Timing(const Timing&) = delete;
  Timing& operator=(const Timing&) = delete;

 private:
  double& sum_;
  double start_ = processor_seconds();
};

}  // namespace clapotis
