#include "common/runner/compare.hpp"

#include <algorithm>
#include <limits>

#include "common/runner/atomic_file.hpp"
#include "common/runner/compare_options.hpp"
#include "common/runner/compare_report.hpp"
#include "common/runner/comparison.hpp"
#include "common/runner/describe.hpp"
#include "common/runner/exit_code.hpp"
#include "common/runner/interrupt.hpp"
#include "common/runner/language_option.hpp"
#include "common/runner/numbers.hpp"
#include "common/runner/progress.hpp"
#include "common/runner/run_folder.hpp"
#include "common/runner/save_sheet.hpp"
#include "common/words.hpp"

namespace clapotis {
namespace {

Side build(const SideOptions& options) {
  return {.text = options.text,
          .stage_title = options.stage->title,
          .simulation = std::make_unique<Simulation>(*options.scene, options.parameters, options.integrator,
                                                     options.threads)};
}

double end_of(const CompareOptions& options, const Side& left) {
  if (options.steps) return static_cast<double>(*options.steps) * left.simulation->dt();
  return options.until.value_or(default_until);
}

/// Distances over time, as the rows of compare.csv have them.
struct Distances {
  Curve largest, rms;
  void add(const Comparison& comparison) {
    if (!comparison.difference()) return;
    for (auto* curve : {&largest, &rms}) curve->xs.push_back(comparison.time());
    largest.ys.push_back(comparison.difference()->largest);
    rms.ys.push_back(comparison.difference()->rms);
  }
};

Plot distance_plot(Distances distances, const Simulation& simulation) {
  const auto& w = words();
  distances.largest.label = w.compare_curve_largest;
  distances.rms.label = w.compare_curve_rms;
  distances.rms.colour = ink::palette().curves[1];
  Plot plot;
  plot.title = w.compare_plot;
  plot.x_label = "t [s]";
  plot.y_label = std::string(w.compare_distance) + " [" + simulation.scene().length_unit + "]";
  plot.curves.push_back(std::move(distances.largest));
  if (simulation.particles().size() > 1)
    plot.curves.push_back(std::move(distances.rms));  // of one they are the same
  plot.log_y = true;
  return plot;
}

/// The error of each side that has a reference, in one plot.
std::optional<Plot> error_plot(const Side& left, const Side& right) {
  std::optional<Plot> both;
  std::size_t colour = 0;
  for (const auto* side : {&left, &right}) {
    if (!side->simulation->setup().reference) continue;
    auto plot = plots(side->history, *side->simulation).back();
    plot.curves.front().label = side == &left ? words().compare_left : words().compare_right;
    plot.curves.front().colour = ink::palette().curves[colour++];
    if (both) {
      both->curves.push_back(plot.curves.front());
    } else {
      both = std::move(plot);
    }
  }
  return both;
}

void save_picture(const RunFolder& folder, Side& left, Side& right, const Distances& distances) {
  std::vector<Plot> curves{distance_plot(distances, *left.simulation)};
  if (auto errors = error_plot(left, right)) curves.push_back(std::move(*errors));
  const double fastest = std::max(left.history.largest_speed(), right.history.largest_speed());
  Viewpoint viewpoint;
  if (fastest > 0) viewpoint.range = {0, fastest};
  auto describe_side = [&](Side& side) {
    auto picture = describe(side.stage_title, *side.simulation, viewpoint);
    picture.title = side.text;
    return picture;
  };
  save_sheet(folder.file("picture.png"), describe_side(left), describe_side(right), curves);
}

int finish(const CompareOptions& options, const RunFolder& folder, const Comparison& comparison, Side& left,
           Side& right) {
  const bool both_diverged = !left.runs() && !right.runs();
  const auto reason = both_diverged ? "diverged" : Interrupt::asked() ? "interrupted" : "until";
  const auto manifest = compare_manifest(comparison, left, right, reason);
  write_file(folder.file("compare.json"), manifest);
  if (options.json) {
    print_result(manifest);
  } else if (!options.quiet) {
    print_result(compare_summary(folder.path(), comparison, left, right));
  }
  for (const auto* side : {&left, &right})
    if (!side->runs()) complain("compare", side->text + ": " + side->divergence);
  if (both_diverged) return exit_diverged;
  return Interrupt::asked() ? exit_interrupted : exit_done;
}

int run(std::span<const Stage> stages, int argc, const char* const* argv) {
  choose_language(argc, argv);
  const auto options = read_compare_options(stages, argc, argv);
  if (options.answer) {
    print_result(*options.answer);
    return exit_done;
  }
  const Interrupt interrupt;
  Side left = build(*options.left), right = build(*options.right);
  const double until =
      reachable(end_of(options, left), std::min(left.simulation->dt(), right.simulation->dt()));
  Comparison comparison(left, right, until, options.every.value_or(0));
  const auto folder = options.out ? RunFolder(*options.out, options.force, files_of_comparison)
                                  : RunFolder::by_date("compare");
  AtomicFile table(folder.file("compare.csv"), Unfinished::keep);
  table.write(compare_header());
  Distances distances;
  {
    Progress progress(!options.quiet);
    do {
      table.write(compare_row(comparison, left, right));
      distances.add(comparison);
      progress.show(comparison.time() / until, comparison.time());
    } while (comparison.advance());
  }
  table.commit();
  save_picture(folder, left, right, distances);
  return finish(options, folder, comparison, left, right);
}

}  // namespace

int run_compare(std::span<const Stage> stages, int argc, const char* const* argv) {
  return with_exit_code(argv[0], [&] { return run(stages, argc, argv); });
}

}  // namespace clapotis
