#pragma once

#include <memory>

#include "common/simulation/simulation.hpp"

namespace clapotis {

/// `count` discs of a scene like cloud, in the closest pack, pressed together by 1 % so that each touches six
/// others, as at the bottom of a settled cloud. `more` are further values of its parameters.
std::unique_ptr<Simulation> packed_cloud(const Scene& scene, long count, int threads = 1,
                                         const Overrides& more = {});

}  // namespace clapotis
