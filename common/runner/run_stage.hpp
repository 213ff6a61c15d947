#pragma once

#include "common/runner/options.hpp"

namespace clapotis {

/// How a stage opens its window. The runner knows no display library, so that a program can do without one.
struct WindowDoor {
  bool (*display_available)() = nullptr;
  int (*open)(const Stage& stage, const Options& options) = nullptr;  ///< returns the exit code
};

/// The whole program of a stage: reads the command line, runs with or without a window, turns every error
/// into one sentence on standard error and an exit code: 0 done, 1 a check failed, 2 usage or bad parameter,
/// 3 no display, 4 input or output, 5 diverged, 130 interrupted.
int run_stage(const Stage& stage, int argc, const char* const* argv, const WindowDoor& window = {});

}  // namespace clapotis
