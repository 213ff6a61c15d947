#include "common/runner/headless.hpp"

#include <algorithm>
#include <limits>

#include "common/runner/atomic_file.hpp"
#include "common/runner/exit_code.hpp"
#include "common/runner/interrupt.hpp"
#include "common/runner/manifest.hpp"
#include "common/runner/numbers.hpp"
#include "common/runner/particle_table.hpp"
#include "common/runner/progress.hpp"
#include "common/runner/run_outputs.hpp"
#include "common/runner/saved_state.hpp"
#include "common/runner/summary.hpp"
#include "common/runner/timing.hpp"
#include "common/simulation/errors.hpp"

namespace clapotis {
namespace {

constexpr double shortest_stretch = 0.02;  // between two looks at the clock [s]
constexpr long longest_stretch = 1 << 20;  // steps
constexpr double never = std::numeric_limits<double>::infinity();

/// One headless run: the loop, and what it leaves.
class HeadlessRun {
 public:
  HeadlessRun(const Stage& stage, const Options& options)
      : stage_(stage),
        options_(options),
        owned_(start_simulation(stage, options)),
        simulation_(*owned_),
        until_(!options.until  ? never
               : options.steps ? options.until->value
                               : reachable(options.until->value, simulation_.dt())),
        most_steps_(options.steps ? options.steps->value : std::numeric_limits<long>::max()),
        outputs_(stage, options, simulation_, length()) {
    result_.first_time = simulation_.time();
    result_.first_step = simulation_.steps();
    result_.start = result_.end = simulation_.energy();
    write_file(outputs_.folder().file("run.json"), run_manifest(stage_, options_, simulation_, result_));
  }

  int run() {
    try {
      advance();
    } catch (const Diverged& error) {
      result_.reason = StopReason::diverged;
      result_.divergence = error.what();
      before_end_.reset();
      finish();
      throw;
    }
    finish();
    if (!failure_.empty()) throw FileError(failure_);
    return result_.reason == StopReason::interrupted ? exit_interrupted : exit_done;
  }

 private:
  /// At most [s].
  [[nodiscard]] double length() const {
    return std::min(until_ - simulation_.time(),
                    static_cast<double>(most_steps_ - simulation_.steps()) * simulation_.dt());
  }

  void advance() {
    Progress progress(!options_.quiet);
    while (!has_ended()) {
      stretch();
      outputs_.write_due();
      progress.show(share_done(), simulation_.time());
    }
  }

  bool has_ended() {
    if (simulation_.time() >= until_) result_.reason = StopReason::until;
    if (simulation_.steps() >= most_steps_) result_.reason = StopReason::steps;
    if (result_.reason == StopReason::running && Interrupt::asked()) result_.reason = StopReason::interrupted;
    return result_.reason != StopReason::running;
  }

  /// Steps until something is to be written, or for a moment: the clock is read once per stretch, not per
  /// step.
  void stretch() {
    const double start = wall_seconds();
    {
      const Timing timing(result_.cpu_seconds);
      const long last = std::min(most_steps_, simulation_.steps() + steps_per_stretch_);
      do {
        if (options_.save && simulation_.next_ends_at(until_)) before_end_ = copy_state(stage_, simulation_);
        simulation_.step(until_);
      } while (simulation_.steps() < last && simulation_.time() < until_ && !outputs_.due() &&
               !Interrupt::asked());
    }
    const double seconds = wall_seconds() - start;
    if (seconds < shortest_stretch) steps_per_stretch_ = std::min(2 * steps_per_stretch_, longest_stretch);
    if (seconds > 2 * shortest_stretch) steps_per_stretch_ = std::max(steps_per_stretch_ / 2, 1L);
  }

  [[nodiscard]] double share_done() const {
    return std::max((simulation_.time() - result_.first_time) / (until_ - result_.first_time),
                    static_cast<double>(simulation_.steps() - result_.first_step) /
                        static_cast<double>(most_steps_ - result_.first_step));
  }

  /// Keeps what was computed, whatever ended the run.
  void finish() {
    {
      Progress progress(!options_.quiet);
      outputs_.finish([&](double share) { progress.show(share, simulation_.time()); });
    }
    result_.end = simulation_.energy();
    result_.largest_error = outputs_.history().largest_error();
    result_.warnings = options_.warnings;
    for (const auto& warning : simulation_.warnings()) result_.warnings.push_back(warning);
    if (!outputs_.video_failure().empty()) note_failure(outputs_.video_failure());
    write_particles(outputs_.folder().file("final.csv"), simulation_);
    outputs_.write_pictures();
    save();
    result_.wall_seconds = wall_seconds() - started_;
    const auto manifest = run_manifest(stage_, options_, simulation_, result_);
    write_file(outputs_.folder().file("run.json"), manifest);
    if (options_.json) {
      print_result(manifest);
    } else if (!options_.quiet) {
      print_result(summary(outputs_.folder().path(), simulation_, result_));
    }
  }

  void save() {
    if (!options_.save) return;
    const auto state = before_end_ ? *std::move(before_end_) : copy_state(stage_, simulation_);
    try {
      write_state(*options_.save, state);
      result_.saved = {options_.save->string(), state.time, state.steps};
    } catch (const FileError& error) {
      note_failure(error.what());
    }
  }

  /// What could not be written although the rest can: said when all else is kept.
  void note_failure(const std::string& sentence) {
    failure_ = sentence;
    result_.warnings.push_back(sentence);
  }

  const Stage& stage_;
  const Options& options_;
  Interrupt interrupt_;
  double started_ = wall_seconds();
  std::unique_ptr<Simulation> owned_;
  Simulation& simulation_;
  double until_;
  long most_steps_;
  RunOutputs outputs_;
  RunResult result_;
  /// What --save keeps of a run that ended at --until: the last state that an uninterrupted run has, too.
  std::optional<SavedState> before_end_;
  std::string failure_;
  long steps_per_stretch_ = 1;
};

}  // namespace

int run_headless(const Stage& stage, const Options& options) {
  check_files(options);
  return HeadlessRun(stage, options).run();
}

}  // namespace clapotis
