#pragma once

#include <limits>
#include <string>
#include <string_view>
#include <vector>

#include "common/runner/options.hpp"
#include "common/simulation/simulation.hpp"

namespace clapotis {

/// Why a run ended. `running` is what a program that was killed leaves behind.
enum class StopReason { running, until, steps, interrupted, diverged };
std::string_view name_of(StopReason reason);

/// What a headless run has come to.
struct RunResult {
  StopReason reason = StopReason::running;
  std::string divergence;   ///< the sentence, when it diverged
  double cpu_seconds = 0;   ///< of the time loop alone, all threads together
  double wall_seconds = 0;  ///< since the run began, output included
  double first_time = 0;    ///< where it went on from, 0 for a run from the start [s]
  long first_step = 0;
  Energy start, end;
  double largest_error = std::numeric_limits<double>::quiet_NaN();  ///< of the rows of the series
  std::vector<std::string> warnings;

  /// The state that --save left; no name: none.
  struct Saved {
    std::string file;
    double time = 0;  ///< [s]
    long steps = 0;
  } saved;
};

/// The text of run.json: what was run, so that it can be run again, and what it came to.
std::string run_manifest(const Stage& stage, const Options& options, Simulation& simulation,
                         const RunResult& result);

/// The keys of run.json that are results, which a replay does not read.
const std::vector<std::string>& result_keys();

}  // namespace clapotis
