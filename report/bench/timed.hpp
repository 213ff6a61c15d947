#pragma once

#include <functional>
#include <string>

#include "common/simulation/simulation.hpp"
#include "report/packed_cloud.hpp"
#include "tests/catch.hpp"

namespace clapotis::bench {

/// Median seconds of one call, by Catch2's BENCHMARK (`--benchmark-samples N` says how many).
double median_seconds(const std::string& name, const std::function<void()>& act);

/// Median seconds of one time step of a running simulation.
double step_seconds(const std::string& name, Simulation& simulation);

/// How many times as fast `other` steps as `base`: the median of what they take in turns one after the other,
/// since a machine that others use too changes its speed from second to second.
double times_as_fast(Simulation& other, Simulation& base);

}  // namespace clapotis::bench
