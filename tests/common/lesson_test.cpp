// The exercises of the READMEs: their form, and that no answer in them has gone stale.

#include <fmt/core.h>

#include <array>

#include "common/lesson/check_lesson.hpp"
#include "common/lesson/measure.hpp"
#include "stage1_bouncing/scenes.hpp"
#include "stage2_cloud/scenes.hpp"
#include "stage3_grid/scenes.hpp"
#include "stage4_sph/scenes.hpp"
#include "stage5_extensions/scenes.hpp"
#include "tests/catch.hpp"

namespace clapotis {
namespace {

using Catch::Matchers::ContainsSubstring;

std::array<Stage, 5> stages() {
  return {stage1::stage(), stage2::stage(), stage3::stage(), stage4::stage(), stage5::stage()};
}

const std::string example = R"(# Title
## Predict, run, explain

### 1. Half the step
**Predict.** What happens
to the `error`?

And to the cost?

**Run.**
```
./lab run stage1_bouncing drop --headless --until 0.4 --integrator rk4 --set dt=0.002
./lab compare stage1/drop stage1/drop:dt=0.002 --until 0.4
ls
```
and look at it.

**Check.**
- run 1 at t = 0.4 s: error = 5.6e-12 m within 2 %
- run 2 left: steps > 10

**Explain.** It falls.

## Limits
)";
const std::string translation = R"(## Prévoir, lancer, expliquer
### 1. Moitié du pas
**Prévoir.** Qu'arrive-t-il ?

**Expliquer.** Il tombe.
)";

/// What is said of the exercise when `from` in it is replaced.
std::string refusal(const std::string& from, const std::string& to) {
  auto text = example;
  text.replace(text.find(from), from.size(), to);
  try {
    static_cast<void>(read_lesson(text, translation));
  } catch (const LessonError& error) {
    return error.what();
  }
  return "nothing was refused";
}

/// A text of one exercise, which tells to run this and expects that.
Exercise of(const std::string& run, const std::string& check) {
  const auto text = "## Predict, run, explain\n### 1. Title\n**Predict.** a\n**Run.**\n```\n" + run +
                    "\n```\n**Check.**\n- run 1: " + check + "\n**Explain.** b\n";
  return read_lesson(text, translation).front();
}

bool holds(const Exercise& exercise) {
  const auto all = stages();
  const auto findings = carry_out(exercise, all);
  return findings.measured(0) && exercise.checks.front().holds(*findings.measured(0));
}

}  // namespace

TEST_CASE("an exercise has its words in both languages, its runs and its checks", "[lesson]") {
  const auto lesson = read_lesson(example, translation);
  REQUIRE(lesson.size() == 1);
  const auto& first = lesson.front();
  CHECK(first.in[0].title == "Half the step");
  CHECK(first.in[0].predict == "What happens to the error?\n\nAnd to the cost?");
  CHECK(first.in[0].explain == "It falls.");
  CHECK(first.in[1].title == "Moitié du pas");
  CHECK(first.in[1].explain == "Il tombe.");
  REQUIRE(first.runs.size() == 3);
  CHECK(first.runs[0].kind == LessonRun::Kind::run);
  CHECK(first.runs[0].stage == "stage1_bouncing");
  CHECK(first.runs[0].summary() == "drop, rk4, dt=0.002, t\u00a0=\u00a00.4\u00a0s");
  CHECK(first.runs[1].kind == LessonRun::Kind::compare);
  CHECK(first.runs[2].kind == LessonRun::Kind::other);
  REQUIRE(first.checks.size() == 2);
  CHECK(first.checks[0].time == 0.4);
  CHECK(first.checks[0].unit == "m");
  CHECK(first.checks[0].holds(5.6e-12 * 1.019));
  CHECK_FALSE(first.checks[0].holds(5.6e-12 * 1.021));
  CHECK(first.checks[1].side == "left");
  CHECK(first.checks[1].holds(11));
  CHECK_FALSE(first.checks[1].holds(10));
}

TEST_CASE("an exercise that does not follow the form is refused with its line and what is wrong",
          "[lesson]") {
  struct Case {
    std::string from, to, said;
  };
  const auto start = example.find("```"), end = example.find("```", start + 3) + 4;
  const auto block = example.substr(start, end - start);
  const Case cases[] = {
      {"### 1.", "### 2.", "README.md, line 4: here \"### 1. Title\" is expected"},
      {"**Predict.** What happens", "What happens", "line 5: here **Predict.** is expected"},
      {block, "", "line 10: **Run.** needs a block of commands"},
      {"ls\n```", "ls", "line 10: the block of commands does not end"},
      {"**Check.**", "Check:", "here **Check.** is expected"},
      {"- run 1 at", "run 1 at", "line 19: a check begins with"},
      {"run 1 at t = 0.4 s:", "run 4:", "line 19: there is no run 4, but 3"},
      {"run 1 at t = 0.4 s:", "run 3:", "line 19: run 3 is neither"},
      {"run 1 at t = 0.4 s:", "run 1 left:", "line 19: run 1 has no left side"},
      {"at t = 0.4 s", "at t = soon s", "line 19: the time should be a number, not \"soon\""},
      {"error = 5", "error ~ 5", "line 19: =, < or > is expected"},
      {"within 2 %", "within 2", "line 19: \"%\" is expected at the end"},
      {"steps > 10", "steps > 10 within 1 %", "line 20: only = has a tolerance"},
      {"**Explain.** It falls.", "**Explain.**", "line 22: **Explain.** says nothing"},
      {"## Predict, run, explain", "## Exercises", "there is no \"## Predict, run, explain\""},
  };
  for (const auto& c : cases) CHECK_THAT(refusal(c.from, c.to), ContainsSubstring(c.said));
}

TEST_CASE("an exercise without a translation, or a translation without an exercise, is refused", "[lesson]") {
  const auto said = [](const std::string& readme, const std::string& french) {
    try {
      static_cast<void>(read_lesson(readme, french));
    } catch (const LessonError& error) {
      return std::string(error.what());
    }
    return std::string("nothing was refused");
  };
  CHECK_THAT(
      said(example, "## Prévoir, lancer, expliquer\n"),
      ContainsSubstring("exercises.fr.md") && ContainsSubstring("\"Half the step\", has no translation"));
  CHECK_THAT(said(example, translation + "\n### 2. Encore\n**Prévoir.** a\n\n**Expliquer.** b\n"),
             ContainsSubstring("exercises.fr.md, line 7: the README has no such exercise"));
  CHECK_THAT(said(example, "## Prévoir, lancer, expliquer\n### 1. Titre\n**Expliquer.** b\n"),
             ContainsSubstring("line 3: here **Prévoir.** is expected"));
}

TEST_CASE("a check that the run does not meet fails, also when it diverged or never came so far",
          "[lesson]") {
  const std::string fall = "./lab run stage1_bouncing drop --headless --until 0.1 --set dt=0.004";
  CHECK(holds(of(fall, "steps = 25")));
  CHECK_FALSE(holds(of(fall, "steps = 26")));
  CHECK_FALSE(holds(of(fall, "diverged_step = 25")));
  CHECK_FALSE(holds(of(fall, "no_such_quantity = 25")));
  const std::string lost = "./lab run stage2_cloud pair --headless --until 5 --set dt=0.05";
  CHECK(holds(of(lost, "diverged_step > 0")));
  CHECK_FALSE(holds(of(lost, "steps > 0")));
}

TEST_CASE("each exercise of each stage gives what its README says", "[lesson]") {
  const auto all = stages();
  for (const auto& stage : all) {
    const auto& lesson = lesson_of(stage.name);
    REQUIRE(lesson.size() >= 3);
    for (const auto& exercise : lesson) {
      const auto findings = carry_out(exercise, all);
      for (std::size_t k = 0; k < exercise.checks.size(); ++k) {
        const auto& check = exercise.checks[k];
        const auto& measured = findings.measured(k);
        INFO(stage.name << "/README.md, line " << check.line << ": " << check.quantity << " is "
                        << (measured ? fmt::format("{:.6g}", *measured) : std::string("never measured")));
        CHECK((measured && check.holds(*measured)));
      }
    }
  }
}

TEST_CASE("the units of the checks are those of what they measure", "[lesson]") {
  for (const auto& stage : stages())
    for (const auto& exercise : lesson_of(stage.name))
      for (const auto& check : exercise.checks) {
        const auto& run = exercise.runs[check.run];
        if (run.kind != LessonRun::Kind::run || check.quantity == diverged_step) continue;
        Simulation simulation(stage.scene(run.words.front()));
        const auto measured = measure(check.quantity, simulation);
        INFO(stage.name << "/README.md, line " << check.line << ": " << check.quantity);
        REQUIRE(measured);
        CHECK(measured->unit == (check.unit.empty() ? "1" : check.unit));
      }
}

}  // namespace clapotis
