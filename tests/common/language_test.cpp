#include <string>

#include "tests/common/programs.hpp"

// The language of a program: --lang, or else the environment. The same numbers and exit codes in both.

using namespace clapotis::testing;
using Catch::Matchers::ContainsSubstring;

namespace {

/// What a wrong value is answered with.
std::string refusal(std::map<std::string, std::string> environment, std::vector<std::string> arguments = {}) {
  const Scratch scratch;
  arguments.insert(arguments.end(), {"--headless", "--set", "mass=-1"});
  const auto ended = run(scratch, stage1, arguments, {.environment = std::move(environment)});
  CHECK(ended.code == 2);
  CHECK(ended.out.empty());
  return ended.err;
}

const std::string english = "stage1_bouncing: mass = -1 kg is out of range: mass must be > 0 kg\n",
                  french = "stage1_bouncing: mass = -1 kg est hors limites\u00a0: il faut mass > 0 kg\n";

}  // namespace

TEST_CASE("a program asked for --lang fr speaks French, with the same exit code", "[language]") {
  CHECK(refusal({}) == english);
  CHECK(refusal({}, {"--lang", "fr"}) == french);
  CHECK(refusal({}, {"--lang=fr"}) == french);
  CHECK(refusal({}, {"--lang", "fr", "--lang", "en"}) == english);
}

TEST_CASE("without --lang the first of LC_ALL, LC_MESSAGES and LANG that says something decides",
          "[language]") {
  CHECK(refusal({{"LANG", "fr_FR.UTF-8"}}) == french);
  CHECK(refusal({{"LANG", "en_GB.UTF-8"}}) == english);
  CHECK(refusal({{"LC_ALL", ""}, {"LC_MESSAGES", "fr_CH"}, {"LANG", "de_CH"}}) == french);
  CHECK(refusal({{"LC_ALL", "C"}, {"LC_MESSAGES", "fr_FR"}, {"LANG", "fr_FR"}}) == english);
  CHECK(refusal({{"LANG", "fr_FR.UTF-8"}}, {"--lang", "en"}) == english);
}

TEST_CASE("the help is French from its first line to its last", "[language]") {
  const Scratch scratch;
  const auto ended = run(scratch, stage1, {"--lang", "fr", "--help"});
  require_done(ended);
  for (const char* part : {"Étape 1 - rebonds", "Utilisation: stage1_bouncing", "Arguments:", "sans fenêtre",
                           "NOM=VALEUR", "Codes de retour", "--headless --until 2"})
    CHECK_THAT(ended.out, ContainsSubstring(part));
  for (const char* part : {"Usage", "Positionals", "the ", "NAME"})
    CHECK_THAT(ended.out, !ContainsSubstring(part));
}

TEST_CASE("compare speaks French, too", "[language]") {
  const Scratch scratch;
  const auto help = run(scratch, compare, {"--lang", "fr", "--help"});
  require_done(help);
  CHECK_THAT(help.out, ContainsSubstring("horloge commune") && ContainsSubstring("--lang"));
  const auto lacks = run(scratch, compare, {"a", "b", "--lang", "fr", "--until"});
  CHECK(lacks.code == 2);
  CHECK(lacks.err == "compare: --until demande une valeur\n");
  const auto ended = run(scratch, compare, {"stage1/drop", "stage1/drop", "--lang=fr", "--until", "0.1"});
  require_done(ended);
  CHECK_THAT(ended.out, ContainsSubstring("évaluations des forces") &&
                            ContainsSubstring("solution analytique") && ContainsSubstring("gauche"));
}

TEST_CASE("numbers, files and what programs read do not depend on the language", "[language]") {
  const auto of = [](const std::string& language) {
    const Scratch scratch;
    require_done(run(scratch, stage1,
                     {"drop", "--headless", "--until", "0.1", "--out", "run", "--lang", language},
                     {.environment = {{"LC_ALL", language == "fr" ? "fr_FR.UTF-8" : "C"}}}));
    const auto config = run(scratch, stage1, {"drop", "--print-config", "--json", "--lang", language});
    return read(scratch / "run/series.csv") + read(scratch / "run/final.csv") + config.out;
  };
  CHECK(of("en") == of("fr"));
}

TEST_CASE("what the system says of a file is French, too", "[language]") {
  const Scratch scratch;
  const auto ended = run(scratch, stage1, {"--lang", "fr", "--config", "no.json"});
  CHECK(ended.code == 4);
  CHECK(ended.err ==
        "stage1_bouncing: impossible de lire no.json\u00a0: aucun fichier ni dossier de ce nom\n");
}
