#pragma once

#include <span>

#include "common/simulation/scene.hpp"

namespace clapotis {

/// The whole program that runs two scenes from the same start on a common clock:
/// `compare STAGE/SCENE[:NAME=VALUE,...] STAGE/SCENE[:NAME=VALUE,...] [--until T | --steps N] [--every DT]
/// [--out DIR] [--video FILE.mp4] [--video-every DT] [--force] [--json] [--quiet]`, where NAME may also be
/// integrator or threads. It leaves compare.csv, compare.json and a side-by-side picture, and the film that
/// is asked for. Exit codes as of a stage; 5 only when both sides have diverged.
int run_compare(std::span<const Stage> stages, int argc, const char* const* argv);

}  // namespace clapotis
