#include "common/runner/compare.hpp"

#include <algorithm>
#include <limits>

#include "common/runner/atomic_file.hpp"
#include "common/runner/compare_options.hpp"
#include "common/runner/compare_picture.hpp"
#include "common/runner/compare_report.hpp"
#include "common/runner/comparison.hpp"
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
          .simulation = std::make_shared<Simulation>(*options.scene, options.parameters, options.integrator,
                                                     options.threads)};
}

double end_of(const CompareOptions& options, const Side& left) {
  if (options.steps) return static_cast<double>(*options.steps) * left.simulation->dt();
  return options.until.value_or(default_until);
}

void save_picture(const RunFolder& folder, const Comparison& comparison, Side& left, Side& right,
                  const Distances& distances) {
  const double fastest = std::max(left.history.largest_speed(), right.history.largest_speed());
  Viewpoint viewpoint;
  if (fastest > 0) viewpoint.range = {0, fastest};
  auto picture = describe_side(left, left.text, left_colour(), viewpoint);
  auto other = describe_side(right, right.text, right_colour(), viewpoint);
  save_sheet(folder.file("picture.png"), picture, beside(left, right, std::move(other), comparison.time()),
             compare_plots(distances, left, right));
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
    if (!side->runs()) complain("compare", side->text + ": " + side->divergence->what());
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
  save_picture(folder, comparison, left, right, distances);
  return finish(options, folder, comparison, left, right);
}

}  // namespace

int run_compare(std::span<const Stage> stages, int argc, const char* const* argv) {
  return with_exit_code(argv[0], [&] { return run(stages, argc, argv); });
}

}  // namespace clapotis
