#include <cmath>
#include <fstream>

#include "common/simulation/errors.hpp"
#include "common/words.hpp"
#include "report/studies/conclusion.hpp"
#include "report/studies/measured.hpp"
#include "report/studies/run_studies.hpp"
#include "tests/catch.hpp"
#include "tests/common/process.hpp"

using namespace clapotis;
using namespace clapotis::studies;

namespace {

/// A study of the squares of 1, 2, 3; `trouble` is called with each before it is measured.
Study squares(std::vector<int>& measured, std::function<void(int)> trouble) {
  const auto points = [&measured, trouble = std::move(trouble)](Effort effort) {
    std::vector<Point> all;
    for (const int x : {1, 2, 3})
      if (effort == Effort::full || x < 3)
        all.push_back({.key = row(x), .measure = [&measured, trouble, x] {
                         trouble(x);
                         measured.push_back(x);
                         return one_row(x * x / 10.0);
                       }});
    return all;
  };
  return {.name = "squares",
          .question = "What is a tenth of a square?",
          .keys = {{"x", "m"}},
          .values = {{"tenth", "m^2"}},
          .points = points,
          .conclude = [](const Table& table) {
            return Conclusion{{{"rows", std::to_string(table.rows().size()), "", "rows"}}, {}};
          }};
}

/// The exit code of `study WORDS... --out FOLDER`.
int run(const Study& study, const std::filesystem::path& folder, std::vector<std::string> words) {
  words.insert(words.begin(), "study");
  words.insert(words.end(), {"--quiet", "--out", folder.string()});
  std::vector<const char*> argv;
  for (const auto& word : words) argv.push_back(word.c_str());
  return run_studies(std::span(&study, 1), static_cast<int>(argv.size()), argv.data());
}

/// The rows of the table that it leaves.
Table left_in(const std::filesystem::path& folder) {
  Table table({{"x", "m"}}, {{"tenth", "m^2"}});
  std::ifstream file(folder / "squares.csv");
  std::string line;
  while (std::getline(file, line))
    if (line[0] >= '0' && line[0] <= '9') {
      const auto first = line.find(','), second = line.find(',', first + 1);
      table.add({line.substr(0, first), line.substr(first + 1, second - first - 1), line.substr(second + 1)});
    }
  return table;
}

}  // namespace

TEST_CASE("a study that was stopped goes on where it was and measures nothing twice", "[study]") {
  const testing::Scratch scratch;
  std::vector<int> measured;
  bool stop = true;
  const auto study = squares(measured, [&](int x) {
    if (x == 2 && stop) throw Interrupted{};
  });
  CHECK(run(study, scratch.path(), {"squares"}) == 130);
  CHECK(left_in(scratch.path()).rows().size() == 1);
  stop = false;
  CHECK(run(study, scratch.path(), {"squares"}) == 0);
  CHECK(measured == std::vector{1, 2, 3});
  const auto table = left_in(scratch.path());
  REQUIRE(table.rows().size() == 3);
  CHECK(table.number(table.rows()[2], "tenth") == 0.9);
  CHECK(testing::read(scratch.path() / "squares.tex") == "\\setval{squares/rows}{\\ensuremath{3}}\n");
  CHECK(run(study, scratch.path(), {"all"}) == 0);
  CHECK(measured.size() == 3);
}

TEST_CASE("a run that diverges is a row of the table and the others are measured", "[study]") {
  const testing::Scratch scratch;
  std::vector<int> measured;
  const auto study = squares(measured, [](int x) {
    if (x == 2) throw Diverged("lost", 7, 0.1, 3);
  });
  CHECK(run(study, scratch.path(), {"squares"}) == 0);
  const auto table = left_in(scratch.path());
  REQUIRE(table.rows().size() == 3);
  CHECK(table.diverged(table.rows()[1]));
  CHECK(std::isnan(table.number(table.rows()[1], "tenth")));
  CHECK_FALSE(table.diverged(table.rows()[2]));
}

TEST_CASE("what another program measured is neither mixed with new rows nor lost", "[study]") {
  const testing::Scratch scratch;
  std::vector<int> measured;
  const auto study = squares(measured, [](int) {});
  REQUIRE(run(study, scratch.path(), {"squares", "--quick"}) == 0);
  const auto quick = testing::read(scratch.path() / "squares.csv");
  CHECK(run(study, scratch.path(), {"squares"}) == 2);  // a quick study is another one
  CHECK(testing::read(scratch.path() / "squares.csv") == quick);
  CHECK(run(study, scratch.path(), {"squares", "--force"}) == 0);
  CHECK(left_in(scratch.path()).rows().size() == 3);
}

TEST_CASE("what a study finds in a refusal is English though the runner speaks French", "[study]") {
  const testing::Scratch scratch;
  std::vector<int> measured;
  std::string refusal;
  const auto study = squares(measured, [&](int) { refusal = words().no_memory; });
  const auto english = std::string(words().no_memory);
  CHECK(run(study, scratch.path(), {"squares", "--lang", "fr"}) == 0);
  CHECK(refusal == english);
  CHECK(language() == Language::french);
  speak(Language::english);
}

TEST_CASE("a name that no study has and an option that there is not are refused", "[study]") {
  const testing::Scratch scratch;
  std::vector<int> measured;
  const auto study = squares(measured, [](int) {});
  CHECK(run(study, scratch.path(), {"square"}) == 2);
  CHECK(run(study, scratch.path(), {"squares", "--quik"}) == 2);
  CHECK(measured.empty());
}

TEST_CASE("a folder that cannot be made ends a study before anything is measured", "[study]") {
  const testing::Scratch scratch;
  testing::write(scratch / "file", "in the way");
  std::vector<int> measured;
  const auto study = squares(measured, [](int) {});
  CHECK(run(study, scratch.path() / "file", {"squares"}) == 4);
  CHECK(measured.empty());
}

TEST_CASE("a power law is found in what follows one, whatever is missing", "[study]") {
  const double none = std::nan("");
  const auto law = power_law({1, 2, 4, 8, 16}, {3, 12, none, 192, 0});
  CHECK(law.exponent == Approx(2));
  CHECK(law.factor == Approx(3));
  CHECK(std::isnan(power_law({1}, {1}).exponent));
}

TEST_CASE("on the Pareto front nobody is beaten in both cost and error", "[study]") {
  const std::vector<double> costs{4, 1, 2, 3, 2}, errors{1, 9, 5, 6, std::nan("")};
  CHECK(pareto_front(costs, errors) == std::vector<std::size_t>{1, 2, 0});
}

TEST_CASE("the report reads powers of ten and marks what TeX would take for itself", "[study]") {
  const Conclusion found{{{"small", "4.5e-06", "m", ""}, {"word", "rk4_5 & 10%", "", ""}},
                         {{"t", {"a", "b"}, {{"x_1", "2.50"}, {"m^2/s", "1000000"}}}}};
  CHECK(latex_of("s", found) ==
        "\\setval{s/small}{\\ensuremath{4.5\\cdot 10^{-6}}~m}\n\\setval{s/word}{rk4\\_5 \\& 10\\%}\n"
        "\\setrows{s/t}{%\nx\\_1 & \\ensuremath{2.50} \\\\\n"
        "m\\textsuperscript{2}/s & \\ensuremath{1\\,000\\,000} \\\\\n}\n");
}

TEST_CASE("a number that is rounded keeps the zeros that count", "[study]") {
  CHECK(rounded(1.5) == "1.50");
  CHECK(rounded(123.4) == "123");
  CHECK(rounded(-1234.5) == "-1230");
  CHECK(rounded(4.5e-6, 2) == "4.5e-06");
  CHECK(rounded(std::nan("")) == "-");
}
