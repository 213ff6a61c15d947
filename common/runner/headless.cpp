#include "common/runner/headless.hpp"

#include <algorithm>
#include <cerrno>
#include <limits>

#include "common/runner/atomic_file.hpp"
#include "common/runner/cadence.hpp"
#include "common/runner/describe.hpp"
#include "common/runner/exit_code.hpp"
#include "common/runner/history.hpp"
#include "common/runner/interrupt.hpp"
#include "common/runner/manifest.hpp"
#include "common/runner/numbers.hpp"
#include "common/runner/particle_table.hpp"
#include "common/runner/progress.hpp"
#include "common/runner/run_folder.hpp"
#include "common/runner/save_sheet.hpp"
#include "common/runner/series.hpp"
#include "common/runner/summary.hpp"
#include "common/runner/timing.hpp"
#include "common/simulation/errors.hpp"
#include "common/words.hpp"

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
        simulation_(stage.scene(options.scene.value), options.parameters, options.integrator.value,
                    options.threads.value),
        until_(!options.until  ? never
               : options.steps ? options.until->value
                               : reachable(options.until->value, simulation_.dt())),
        most_steps_(options.steps ? options.steps->value : std::numeric_limits<long>::max()),
        folder_(options.out ? RunFolder(*options.out, options.force, files_of_run)
                            : RunFolder::by_date(stage.name + "-" + options.scene.value)),
        rows_(options.every.value_or(
            usual_interval(simulation_.dt(), length(), simulation_.particles().size()))),
        frames_(options.frames.value_or(0)),
        series_(folder_.file("series.csv"), simulation_) {}

  int run() {
    begin();
    try {
      advance();
    } catch (const Diverged& error) {
      result_.reason = StopReason::diverged;
      result_.divergence = error.what();
      finish();
      throw;
    }
    finish();
    return result_.reason == StopReason::interrupted ? exit_interrupted : exit_done;
  }

 private:
  /// At most [s].
  [[nodiscard]] double length() const {
    return std::min(until_, static_cast<double>(most_steps_) * simulation_.dt());
  }

  void begin() {
    result_.start = result_.end = simulation_.energy();
    write_file(folder_.file("run.json"), run_manifest(stage_, options_, simulation_, result_));
    record();
    if (options_.frames) write_frame();
  }

  void advance() {
    Progress progress(!options_.quiet);
    while (!has_ended()) {
      stretch();
      if (rows_.due(simulation_.time(), simulation_.dt())) record();
      if (options_.frames && frames_.due(simulation_.time(), simulation_.dt())) write_frame();
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
      do simulation_.step(until_);
      while (simulation_.steps() < last && simulation_.time() < until_ && !is_output_due() &&
             !Interrupt::asked());
    }
    const double seconds = wall_seconds() - start;
    if (seconds < shortest_stretch) steps_per_stretch_ = std::min(2 * steps_per_stretch_, longest_stretch);
    if (seconds > 2 * shortest_stretch) steps_per_stretch_ = std::max(steps_per_stretch_ / 2, 1L);
  }

  [[nodiscard]] bool is_output_due() const {
    const double time = simulation_.time(), dt = simulation_.dt();
    return rows_.due(time, dt) || (options_.frames && frames_.due(time, dt));
  }

  [[nodiscard]] double share_done() const {
    return std::max(simulation_.time() / until_,
                    static_cast<double>(simulation_.steps()) / static_cast<double>(most_steps_));
  }

  void record() {
    rows_.serve(simulation_.time(), simulation_.dt());
    const Moment moment(simulation_);
    series_.add(moment);
    history_.add(simulation_, moment.energy);
    last_recorded_ = simulation_.steps();
  }

  void write_frame() {
    frames_.serve(simulation_.time(), simulation_.dt());
    write_particles(folder_.frame(frame_count_++), simulation_);
  }

  /// Keeps what was computed, whatever ended the run.
  void finish() {
    if (last_recorded_ != simulation_.steps()) record();
    series_.close();
    result_.end = simulation_.energy();
    result_.largest_error = history_.largest_error();
    result_.warnings = options_.warnings;
    for (const auto& warning : simulation_.warnings()) result_.warnings.push_back(warning);
    write_particles(folder_.file("final.csv"), simulation_);
    write_pictures();
    result_.wall_seconds = wall_seconds() - started_;
    const auto manifest = run_manifest(stage_, options_, simulation_, result_);
    write_file(folder_.file("run.json"), manifest);
    if (options_.json) {
      print_result(manifest);
    } else if (!options_.quiet) {
      print_result(summary(folder_.path(), simulation_, result_));
    }
  }

  void write_pictures() {
    Viewpoint viewpoint;
    viewpoint.colour_by = simulation_.setup().colour_by;
    const bool by_speed = viewpoint.colour_by == "speed" && !simulation_.setup().fluid;
    if (by_speed && history_.largest_speed() > 0) viewpoint.range = {0, history_.largest_speed()};
    const auto picture = describe(stage_.title, simulation_, viewpoint);
    const auto curves = plots(history_, simulation_);
    save_sheet(folder_.file("picture.png"), picture, curves);
    if (options_.picture) save_sheet(*options_.picture, picture, curves);
  }

  const Stage& stage_;
  const Options& options_;
  Interrupt interrupt_;
  double started_ = wall_seconds();
  Simulation simulation_;
  double until_;
  long most_steps_;
  RunFolder folder_;
  Cadence rows_, frames_;
  Series series_;
  History history_;
  RunResult result_;
  long last_recorded_ = -1, frame_count_ = 0, steps_per_stretch_ = 1;
};

void check_picture_folder(const Options& options) {
  if (!options.picture) return;
  const auto folder = options.picture->has_parent_path() ? options.picture->parent_path() : ".";
  if (!std::filesystem::is_directory(folder)) refuse_file(words().cannot_write, *options.picture, ENOENT);
}

}  // namespace

int run_headless(const Stage& stage, const Options& options) {
  check_picture_folder(options);
  return HeadlessRun(stage, options).run();
}

}  // namespace clapotis
