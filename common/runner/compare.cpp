#include "common/runner/compare.hpp"

#include <algorithm>
#include <limits>

#include "common/runner/atomic_file.hpp"
#include "common/runner/compare_options.hpp"
#include "common/runner/compare_picture.hpp"
#include "common/runner/compare_report.hpp"
#include "common/runner/comparison.hpp"
#include "common/runner/exit_code.hpp"
#include "common/runner/film.hpp"
#include "common/runner/interrupt.hpp"
#include "common/runner/language_option.hpp"
#include "common/runner/numbers.hpp"
#include "common/runner/progress.hpp"
#include "common/runner/run_folder.hpp"
#include "common/runner/save_sheet.hpp"
#include "common/simulation/errors.hpp"
#include "common/words.hpp"

namespace clapotis {
namespace {

Side build(const SideOptions& options) {
  return {.text = options.text,
          .stage_title = options.stage->title,
          .simulation = std::make_shared<Simulation>(*options.scene, options.parameters, options.integrator,
                                                     options.threads)};
}

/// One comparison: the loop, and what it leaves.
class HeadlessComparison {
 public:
  explicit HeadlessComparison(const CompareOptions& options)
      : options_(options),
        left_(build(*options.left)),
        right_(build(*options.right)),
        until_(reachable(end(), std::min(left_.simulation->dt(), right_.simulation->dt()))),
        comparison_(left_, right_, until_, options.every.value_or(0)),
        folder_(options.out ? RunFolder(*options.out, options.force, files_of_comparison)
                            : RunFolder::by_date("compare")),
        table_(folder_.file("compare.csv"), Unfinished::keep) {
    if (options.video)
      film_.begin(*options.video, 0, options.video_every.value_or(usual_film_interval(until_)));
    table_.write(compare_header());
  }

  int run() {
    advance();
    table_.commit();
    finish_film();
    save_picture();
    report();
    for (const auto* side : {&left_, &right_})
      if (!side->runs()) complain("compare", side->text + ": " + side->divergence->what());
    if (both_diverged()) return exit_diverged;
    if (!film_.failure().empty()) throw FileError(film_.failure());
    return Interrupt::asked() ? exit_interrupted : exit_done;
  }

 private:
  [[nodiscard]] double end() const {
    if (options_.steps) return static_cast<double>(*options_.steps) * left_.simulation->dt();
    return options_.until.value_or(default_until);
  }
  [[nodiscard]] bool both_diverged() const { return !left_.runs() && !right_.runs(); }

  /// Rows and frames of the film come at instants of their own.
  void advance() {
    Progress progress(!options_.quiet);
    write_row();
    for (bool goes_on = true; goes_on;) {
      const bool one_more = film_.due(until_, left_.simulation->dt()) && !both_diverged();
      const auto piece =
          comparison_.advance_to(one_more ? film_.next() : std::numeric_limits<double>::infinity());
      if (piece == Comparison::Piece::row) {
        write_row();
        progress.show(comparison_.time() / until_, comparison_.time());
      } else {
        goes_on = one_more && !Interrupt::asked();
        if (one_more) shoot();
      }
    }
  }

  void write_row() {
    table_.write(compare_row(comparison_, left_, right_));
    distances_.add(comparison_);
  }

  void shoot() {
    auto left = describe_side(left_, left_.text, left_colour(), {});
    auto right = describe_side(right_, right_.text, right_colour(), {});
    share_colours(left, right, left_, right_);
    auto both = beside(left_, right_, std::move(right), time_of_both(left_, right_));
    film_.add(std::move(left), compare_plots(distances_, left_, right_), film_.next(), 0, std::move(both));
  }

  /// Of a comparison that nobody can go on with, the last frame says why.
  void finish_film() {
    if (both_diverged() && film_.due(until_, left_.simulation->dt())) shoot();
    Progress progress(!options_.quiet);
    film_.finish([&](double share) { progress.show(share, comparison_.time()); });
  }

  /// Both in the range of the whole run, since all particles may rest at its end.
  void save_picture() {
    const double fastest = std::max(left_.history.largest_speed(), right_.history.largest_speed());
    Viewpoint viewpoint;
    if (fastest > 0) viewpoint.range = {0, fastest};
    const auto left = describe_side(left_, left_.text, left_colour(), viewpoint);
    auto right = describe_side(right_, right_.text, right_colour(), viewpoint);
    save_sheet(folder_.file("picture.png"), left, beside(left_, right_, std::move(right), comparison_.time()),
               compare_plots(distances_, left_, right_));
  }

  void report() const {
    const auto reason = both_diverged() ? "diverged" : Interrupt::asked() ? "interrupted" : "until";
    auto warnings = compare_warnings(comparison_, left_, right_);
    if (!film_.failure().empty()) warnings.push_back(film_.failure());
    const auto manifest = compare_manifest(comparison_, left_, right_, reason, warnings);
    write_file(folder_.file("compare.json"), manifest);
    if (options_.json) {
      print_result(manifest);
    } else if (!options_.quiet) {
      print_result(compare_summary(folder_.path(), comparison_, left_, right_, warnings));
    }
  }

  const CompareOptions& options_;
  Interrupt interrupt_;
  Side left_, right_;
  double until_;
  Comparison comparison_;
  RunFolder folder_;
  AtomicFile table_;
  Distances distances_;
  WantedFilm film_;
};

int run(std::span<const Stage> stages, int argc, const char* const* argv) {
  choose_language(argc, argv);
  const auto options = read_compare_options(stages, argc, argv);
  if (options.answer) {
    print_result(*options.answer);
    return exit_done;
  }
  if (options.video) {
    check_place(*options.video);
    require_encoder(*options.video);
  }
  return HeadlessComparison(options).run();
}

}  // namespace

int run_compare(std::span<const Stage> stages, int argc, const char* const* argv) {
  return with_exit_code(argv[0], [&] { return run(stages, argc, argv); });
}

}  // namespace clapotis
