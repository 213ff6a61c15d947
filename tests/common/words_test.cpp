// Both languages. That no word is missing, and no hole of a sentence, the compiler sees; here stands what it
// cannot see: that names which come from the scenes have their French, too.

#include "common/words.hpp"

#include <algorithm>
#include <array>
#include <cctype>

#include "common/runner/describe.hpp"
#include "common/runner/history.hpp"
#include "common/simulation/errors.hpp"
#include "common/simulation/simulation.hpp"
#include "stage1_bouncing/scenes.hpp"
#include "stage2_cloud/scenes.hpp"
#include "stage3_grid/scenes.hpp"
#include "stage4_sph/scenes.hpp"
#include "stage5_extensions/scenes.hpp"
#include "tests/catch.hpp"

namespace clapotis {
namespace {

using Catch::Matchers::ContainsSubstring;

/// What is said while it lives is French.
class InFrench {
 public:
  InFrench() { speak(Language::french); }
  ~InFrench() { speak(Language::english); }
  InFrench(const InFrench&) = delete;
  InFrench& operator=(const InFrench&) = delete;
};

std::array<Stage, 5> stages() {
  return {stage1::stage(), stage2::stage(), stage3::stage(), stage4::stage(), stage5::stage()};
}

/// Some are the same in both languages, and yet have a line in the table.
bool is_proper_name(std::string_view name) {
  return std::any_of(name.begin(), name.end(), [](unsigned char c) { return std::isdigit(c) != 0; });
}

std::string refusal(const Stage& stage, const char* name, const char* value) {
  try {
    const Simulation simulation(stage.scenes.front(), {{name, {value}}});
  } catch (const BadInput& error) {
    return error.what();
  }
  return "nothing was refused";
}

}  // namespace

TEST_CASE("what scenes show by name has a French name: titles, references, limits, quantities, parameters",
          "[words]") {
  const InFrench french;
  for (const auto& stage : stages()) {
    CHECK(called(stage.title) != stage.title);
    for (const auto& scene : stage.scenes) {
      INFO(stage.name << "/" << scene.name);
      const Simulation simulation(scene);
      if (const auto& reference = simulation.setup().reference) {
        INFO(reference->name);
        CHECK((called(reference->name) != reference->name || is_proper_name(reference->name)));
      }
      for (const auto& limit : simulation.limits()) {
        INFO(limit.name);
        CHECK(called(limit.name, Naming::limit) != limit.name);
      }
      for (const auto& quantity : colourings(simulation)) {
        INFO(quantity);
        CHECK((called(quantity) != quantity || quantity == "force"));
      }
      for (const auto& parameter : simulation.parameters().all()) {
        INFO(parameter.name);
        CHECK(meaning(parameter.name) != parameter.name);
      }
    }
  }
}

TEST_CASE("what one types is the same in both languages: scenes, presets, integrators", "[words]") {
  const InFrench french;
  for (const auto& stage : stages()) {
    for (const auto& name : integrator_names(stage.matter())) CHECK(called(name) == name);
    for (const auto& scene : stage.scenes) {
      CHECK(called(scene.name) == scene.name);
      for (const auto& preset : scene.presets) CHECK(called(preset.name) == preset.name);
    }
  }
}

TEST_CASE("a refusal in French names what, its value, its range and unit, and the nearest name", "[words]") {
  const auto stage = stage1::stage();
  const auto in_english = refusal(stage, "mass", "-1");
  CHECK(in_english == "mass = -1 kg is out of range: mass must be > 0 kg");
  const InFrench french;
  CHECK(refusal(stage, "mass", "-1") == "mass = -1 kg est hors limites\u00a0: il faut mass > 0 kg");
  CHECK(refusal(stage, "gravity", "9,81") ==
        "gravity = 9,81 n'est pas un nombre (les décimales s'écrivent avec un point, 0.5)\u00a0: il faut "
        "gravity >= 0 px/s^2");
  CHECK_THAT(refusal(stage, "gravty", "3"), ContainsSubstring("vouliez-vous dire gravity\u00a0?"));
}

TEST_CASE("a picture's words change with the language, its numbers do not", "[words]") {
  const auto stage = stage1::stage();
  Simulation simulation(stage.scene("drop"), {{"dt", {"0.004"}}});
  simulation.step();
  History history;
  history.add(simulation);
  const auto picture = [&] { return describe(stage.title, simulation); };
  const auto titles = [&] {
    std::vector<std::string> all;
    for (const auto& plot : plots(history, simulation)) all.push_back(plot.title);
    return all;
  };
  const auto in_english = picture();
  CHECK(in_english.title == "Stage 1 - bouncing - drop");
  CHECK(titles() == std::vector<std::string>{"Energies", "Error against closed form"});
  const InFrench french;
  const auto in_french = picture();
  CHECK(in_french.title == "Étape 1 - rebonds - drop");
  CHECK(titles() == std::vector<std::string>{"Énergies", "Écart à la référence (solution analytique)"});
  CHECK(in_french.subtitle == in_english.subtitle);
  CHECK(in_french.note == in_english.note);
}

}  // namespace clapotis
