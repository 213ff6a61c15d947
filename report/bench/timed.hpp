#pragma once

#include <functional>
#include <string>

#include "common/simulation/simulation.hpp"
#include "tests/catch.hpp"

namespace clapotis::bench {

/// Median seconds of one call, by Catch2's BENCHMARK (`--benchmark-samples N` says how many).
double median_seconds(const std::string& name, const std::function<void()>& act);

/// Median seconds of one time step of a running simulation.
double step_seconds(const std::string& name, Simulation& simulation);

/// How many times as fast `other` steps as `base`: the median of what they take in turns one after the other,
/// since a machine that others use too changes its speed from second to second.
double times_as_fast(Simulation& other, Simulation& base);

/// `count` discs of the scene cloud in the closest pack, pressed together by 1 % so that
/// each touches six others, as at the bottom of a settled cloud.
std::unique_ptr<Simulation> packed_cloud(const Stage& stage, long count, int threads = 1);

}  // namespace clapotis::bench
