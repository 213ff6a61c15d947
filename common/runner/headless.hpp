#pragma once

#include "common/runner/options.hpp"

namespace clapotis {

/// Runs a scene without a window and leaves its run folder; prints a summary, or run.json with --json.
/// Returns the exit code: 0, or 130 when it was interrupted. Throws BadInput, FileError, and Diverged after
/// what was computed has been kept.
int run_headless(const Stage& stage, const Options& options);

}  // namespace clapotis
