#include "report/studies/run_studies.hpp"

#include <CLI/CLI.hpp>
#include <algorithm>
#include <filesystem>

#include "common/runner/atomic_file.hpp"
#include "common/runner/command_line.hpp"
#include "common/runner/exit_code.hpp"
#include "common/runner/interrupt.hpp"
#include "common/runner/language_option.hpp"
#include "common/runner/machine.hpp"
#include "common/runner/manifest.hpp"
#include "common/runner/progress.hpp"
#include "common/simulation/errors.hpp"
#include "common/words.hpp"
#include "report/studies/conclusion.hpp"
#include "report/studies/measured.hpp"

namespace clapotis::studies {
namespace {

namespace fs = std::filesystem;

struct Options {
  std::vector<std::string> names;
  std::string out, lang;
  bool quick = false, force = false, quiet = false, help = false;
};

const std::vector<std::string> with_value{"--out", "--lang"},
    without_value{"--quick", "--force", "--quiet", "--help"};

/// Where the tables of one effort are kept: those of a quick study are never taken for the others.
fs::path folder_of(const Options& options) {
  if (!options.out.empty()) return options.out;
  return options.quick ? "runs/studies-quick" : "runs/studies";
}

std::string about(const Study& study, const Options& options) {
  return fmt::format("{}: {}\n./lab study {}{}\n{}, {}, {}", study.name, study.question, study.name,
                     options.quick ? " --quick" : "", version(), compiler(), processor());
}

/// What studies measure and find is English, like the report, whatever the runner speaks.
class InEnglish {
 public:
  InEnglish() { speak(Language::english); }
  ~InEnglish() { speak(before_); }
  InEnglish(const InEnglish&) = delete;
  InEnglish& operator=(const InEnglish&) = delete;

 private:
  Language before_ = language();
};

/// The rows of a point, whole: with its key, and how it came out.
std::vector<Row> measured(const Point& point, std::size_t width) {
  const InEnglish meanwhile;
  std::vector<Row> rows;
  const auto complete = [&](Row values, const char* outcome) {
    Row row = point.key;
    row.insert(row.end(), values.begin(), values.end());
    row.resize(width - 1, "nan");
    row.emplace_back(outcome);
    rows.push_back(std::move(row));
  };
  try {
    for (auto& values : point.measure()) complete(std::move(values), "done");
  } catch (const Diverged&) {
    rows.clear();
    complete({}, "diverged");
  }
  return rows;
}

void conclude(const Study& study, const Options& options, const fs::path& file, const Table& table) {
  const auto conclusion = study.conclude(table);
  auto notes = file;
  write_file(notes.replace_extension("tex"), latex_of(study.name, conclusion));
  const auto lost = std::count_if(table.rows().begin(), table.rows().end(),
                                  [&](const Row& row) { return table.diverged(row); });
  if (options.quiet) return;
  print_result(
      say(words().study.done, fmt::arg("study", study.name), fmt::arg("file", file.string()),
          fmt::arg("rows", table.rows().size()), fmt::arg("diverged", lost)) +
      (table.builds() > 1 ? say(words().study.several_builds, fmt::arg("count", table.builds())) : "") +
      text_of(conclusion));
}

/// With what the tables of a folder were measured, for the report.
void note_machine(const fs::path& folder) {
  const Conclusion machine{.findings = {{"version", version(), "", ""},
                                        {"compiler", compiler(), "", ""},
                                        {"processor", processor(), "", ""}}};
  write_file(folder / "machine.tex", latex_of("machine", machine));
}

/// False when it was interrupted.
bool run(const Study& study, const Options& options) {
  const auto file = folder_of(options) / (study.name + ".csv");
  const auto origin = about(study, options);
  Table before(study.keys, study.values);
  if (fs::exists(file) && !options.force) before.read(file, origin);

  const auto points = study.points(options.quick ? Effort::quick : Effort::full);
  std::vector<std::vector<Row>> rows;  // of each point, in their order, whenever they were measured
  double done = 0, left = 0;
  for (const auto& point : points) {
    rows.push_back(before.of(point.key));
    if (rows.back().empty()) left += point.weight;
  }
  Progress progress(!options.quiet);
  for (std::size_t k = 0; k < points.size(); ++k) {
    if (!rows[k].empty()) continue;
    progress.show(done / left, study.name + ": " + joined(points[k].key));
    try {
      heed_interrupt();
      rows[k] = measured(points[k], before.width());
    } catch (const Interrupted&) {
      return false;
    } catch (...) {  // a helper that Ctrl-C ended may have its own words for it
      if (Interrupt::asked()) return false;
      throw;
    }
    before.note_build(program_fingerprint());
    write_file(file, before.with(rows).csv(origin));  // whole: a killed study has all points but the last
    done += points[k].weight;
  }
  conclude(study, options, file, before.with(rows));
  return true;
}

Options read_options(std::span<const Study> studies, int argc, const char* const* argv, std::string& help) {
  const auto& w = words();
  Options options;
  CLI::App app{std::string(w.study.help)};
  app.name("study");
  name_parts(app);
  app.set_help_flag();
  app.add_option("NAME", options.names, std::string(w.study.help_name))->type_name("");
  app.add_option("--out", options.out, std::string(w.study.help_out))
      ->type_name(std::string(called("DIR")))
      ->take_last();
  app.add_option("--lang", options.lang, std::string(w.help_lang))->type_name("en|fr")->take_last();
  app.add_flag("--quick", options.quick, std::string(w.study.help_quick));
  app.add_flag("--force", options.force, std::string(w.study.help_force));
  app.add_flag("--quiet", options.quiet, std::string(w.help_quiet));
  app.add_flag("-h,--help", options.help, std::string(w.help_help));
  app.allow_extras();
  std::string list;
  std::vector<std::string> names{"all"};
  for (const auto& study : studies) {
    list += fmt::format("\n  {:24}{}", study.name, study.question);
    names.push_back(study.name);
  }
  app.footer(say(w.study.list, fmt::arg("studies", list)));
  refuse_values(argc, argv, with_value, without_value);
  try {
    app.parse(argc, argv);
  } catch (const CLI::ParseError& error) {
    throw BadInput(error.what());
  }
  refuse_unknown(app, with_value, without_value);
  for (const auto& name : options.names)
    if (std::find(names.begin(), names.end(), name) == names.end())
      throw BadInput(unknown_name("study", name, names));
  help = app.help();
  return options;
}

bool wanted(const Options& options, const Study& study) {
  return std::any_of(options.names.begin(), options.names.end(),
                     [&](const auto& name) { return name == "all" || name == study.name; });
}

}  // namespace

int run_studies(std::span<const Study> studies, int argc, const char* const* argv) {
  return with_exit_code(argv[0], [&] {
    choose_language(argc, argv);
    std::string help;
    const auto options = read_options(studies, argc, argv, help);
    if (options.help || options.names.empty()) {
      print_result(help);
      return exit_done;
    }
    const Interrupt interrupt;
    const auto folder = folder_of(options);
    std::error_code error;
    fs::create_directories(folder, error);
    if (error) refuse_file(words().cannot_write, folder, error.value());
    for (const auto& study : studies) {
      if (!wanted(options, study) || run(study, options)) continue;
      complain("study", say(words().study.interrupted, fmt::arg("study", study.name)));
      return exit_interrupted;
    }
    note_machine(folder);
    return exit_done;
  });
}

}  // namespace clapotis::studies
