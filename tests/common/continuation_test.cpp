#include <filesystem>
#include <fstream>
#include <limits>
#include <nlohmann/json.hpp>

#include "common/particles/pack.hpp"
#include "common/runner/machine.hpp"
#include "common/runner/saved_state.hpp"
#include "common/simulation/errors.hpp"
#include "common/simulation/tools.hpp"
#include "common/words.hpp"
#include "stage1_bouncing/scenes.hpp"
#include "stage2_cloud/scenes.hpp"
#include "stage3_grid/scenes.hpp"
#include "stage4_sph/scenes.hpp"
#include "stage5_extensions/scenes.hpp"
#include "tests/catch.hpp"
#include "tests/common/process.hpp"
#include "tests/common/runs.hpp"

// A run goes on from a saved state as if nothing had been: the same bits in all that a step depends on.

using namespace clapotis;
using namespace clapotis::tests;
using Catch::Matchers::ContainsSubstring;
using clapotis::testing::Scratch;
using Json = nlohmann::json;

namespace {

const std::vector<Stage>& stages() {
  static const std::vector<Stage> all{stage1::stage(), stage2::stage(), stage3::stage(), stage4::stage(),
                                      stage5::stage()};
  return all;
}

/// The scene with a quarter of its particles, where it has that many.
Overrides coarse(const Scene& scene) {
  const Simulation usual(scene);
  const auto* spacing = usual.parameters().find("spacing");
  if (spacing == nullptr || spacing->derived) return {};
  return typed({{"spacing", 2 * spacing->value}, {"cfl", 0.2}});  // explicit Euler bears no more in a drop
}

/// All that the next steps depend on.
std::string state_of(Simulation& simulation) {
  StateBytes state;
  simulation.pass_state(state);
  return state.bytes();
}

/// Through a file and back.
std::unique_ptr<Simulation> through_file(const Stage& stage, Simulation& simulation, int threads = 1) {
  const Scratch scratch;
  write_state(scratch / "run.state", copy_state(stage, simulation));
  return resume_simulation(stage, read_state(scratch / "run.state", stage), threads);
}

/// A small state file, and what becomes of it.
struct StateFile {
  Scratch scratch;
  Stage stage = stage1::stage();
  std::string bytes;

  StateFile() {
    Simulation simulation(stage.scene("drop"));
    run_steps(simulation, 5);
    write_state(path(), copy_state(stage, simulation));
    bytes = testing::read(path());
  }
  [[nodiscard]] std::filesystem::path path() const { return scratch / "run.state"; }
  /// Why it is refused when it holds `changed`.
  [[nodiscard]] std::string refusal(const std::string& changed) const {
    testing::write(path(), changed);
    try {
      static_cast<void>(resume_simulation(stage, read_state(path(), stage), 1));
    } catch (const FileError& error) {
      return error.what();
    }
    return "not refused";
  }
  /// With another value in the header, and a sum that belongs to it: a file of another program.
  template <class Value>
  [[nodiscard]] std::string with(const std::string& key, const Value& value) const {
    const auto newline = bytes.find('\n');
    std::istringstream line(bytes.substr(0, newline));
    std::string word;
    std::size_t format = 0, header = 0, state = 0;
    line >> word >> word >> format >> header >> state;
    auto json = Json::parse(bytes.substr(newline + 1, header));
    json[key] = value;
    const auto text = json.dump();
    auto whole = fmt::format("Clapotis state {} {} {}\n", format, text.size(), state) + text +
                 bytes.substr(newline + 1 + header, state);
    const auto sum = fingerprint(whole);
    whole.append(reinterpret_cast<const char*>(&sum), sizeof sum);
    return whole;
  }
};

}  // namespace

TEST_CASE("a resumed run has the bits of one that was never interrupted, in every scene with every scheme",
          "[continuation]") {
  for (const auto& stage : stages())
    for (const auto& scene : stage.scenes)
      for (const auto& scheme : schemes()) {
        CAPTURE(stage.name, scene.name, scheme.name);
        Simulation whole(scene, coarse(scene), scheme.name);
        run_steps(whole, 21);  // five steps after a checkpoint
        const auto resumed = through_file(stage, whole);
        CHECK(state_of(*resumed) == state_of(whole));
        run_steps(whole, 4);
        run_steps(*resumed, 4);
        CHECK(resumed->steps() == 25);
        CHECK(state_of(*resumed) == state_of(whole));
      }
}

TEST_CASE("a long run resumed twice, with more threads, has the bits of one that was never interrupted",
          "[continuation]") {
  const auto stage = stage4::stage();
  const auto& scene = stage.scene("dam_break");
  const auto parameters = typed({{"spacing", 0.1}, {"tank_width", 1.5}});  // the water hits the wall
  Simulation whole(scene, parameters), first(scene, parameters);
  run_steps(whole, 300);
  run_steps(first, 100);
  const auto second = through_file(stage, first, 2);
  run_steps(*second, 77);
  const auto third = through_file(stage, *second);
  run_steps(*third, 123);
  CHECK(third->threads() == 1);
  CHECK(state_of(*third) == state_of(whole));
}

TEST_CASE("particles between walls, impacts located inside the step, go on with the same bits",
          "[continuation]") {
  const auto stage = stage1::stage();
  for (const auto* integrator : {"velocity_verlet", "rk4", "bogacki_shampine"}) {
    Simulation whole(stage.scene("drop"), typed({{"drag", 0.3}}), integrator);
    run_to(whole, 1.7);  // some impacts
    const auto resumed = through_file(stage, whole);
    run_to(whole, 3.1);
    run_to(*resumed, 3.1);
    CHECK(state_of(*resumed) == state_of(whole));
    CHECK(resumed->error() == whole.error());
  }
}

TEST_CASE("a flow whose particles come and go goes on with the same bits, ids included", "[continuation]") {
  const auto stage = stage5::stage();
  Simulation whole(stage.scene("channel"), {{"spacing", {"1e-3"}}});
  while (whole.system().left == 0) whole.step();
  run_steps(whole, 20);
  const auto resumed = through_file(stage, whole);
  CHECK(state_of(*resumed) == state_of(whole));
  run_steps(whole, 60);
  run_steps(*resumed, 60);
  CHECK(whole.particles().id(whole.particles().size() - 1) >= whole.particles().size());
  CHECK(state_of(*resumed) == state_of(whole));
}

TEST_CASE("what a hand has done to a liquid, and does, goes on with the same bits", "[continuation]") {
  const auto stage = stage5::stage();
  Simulation whole(
      stage.scene("sandbox"),
      {{"spacing", {"0.04"}}, {"tank_width", {"1.2"}}, {"tank_height", {"1"}}, {"depth", {"0.32"}}});
  run_steps(whole, 10);
  draw_obstacle(whole, {0.3, 0.6}, 0.1);
  add_drop(whole, {0.8, 0.7}, 0.12);
  erase(whole, {1.1, 0.1}, 0.08);
  hold_hand(whole, {0.6, 0.4}, 1);
  shake_tank(whole, {0.5, 0});
  run_steps(whole, 30);
  const auto resumed = through_file(stage, whole);
  CHECK(resumed->model().obstacles().rows() > 10);
  CHECK(state_of(*resumed) == state_of(whole));
  run_steps(whole, 40);
  run_steps(*resumed, 40);
  CHECK(state_of(*resumed) == state_of(whole));
}

TEST_CASE("what was changed while a scene ran stays changed, and its reference stays away",
          "[continuation]") {
  const auto stage = stage4::stage();
  Simulation whole(stage.scene("still_water"), coarse(stage.scene("still_water")));
  run_steps(whole, 10);
  whole.set("alpha", "0.3");
  whole.set("gravity", "4");
  run_steps(whole, 10);
  whole.set("gravity", "15", Origin::flag);
  const auto resumed = through_file(stage, whole);
  run_steps(whole, 10);
  run_steps(*resumed, 10);
  CHECK(resumed->parameters().value("gravity") == 15);
  CHECK(resumed->parameters().find("gravity")->origin == Origin::flag);
  CHECK(resumed->parameters().value("alpha") == 0.3);
  CHECK_FALSE(resumed->setup().reference.has_value());
  CHECK(state_of(*resumed) == state_of(whole));
}

TEST_CASE("a resumed run that diverges stands on the same last good state", "[continuation]") {
  const auto stage = stage4::stage();
  Simulation whole(stage.scene("dam_break"), typed({{"spacing", 0.1}}));
  run_steps(whole, 20);
  const auto resumed = through_file(stage, whole);
  for (auto* simulation : {&whole, resumed.get()}) {
    run_steps(*simulation, 6);
    simulation->system().velocity(3, 1) = 1e30;
    CHECK_THROWS_AS(simulation->step(), Diverged);
    CHECK(simulation->steps() == 26);
  }
  CHECK(state_of(*resumed) == state_of(whole));
}

TEST_CASE("a file that was cut short or damaged anywhere is refused, and says what to do", "[continuation]") {
  const StateFile file;
  REQUIRE(file.refusal(file.bytes) == "not refused");
  for (const std::size_t length :
       {std::size_t{0}, std::size_t{7}, file.bytes.find('\n') - 2, file.bytes.find('\n') + 40,
        file.bytes.size() / 2, file.bytes.size() - 1}) {
    CAPTURE(length);
    CHECK_THAT(file.refusal(file.bytes.substr(0, length)),
               ContainsSubstring("run.state") && !ContainsSubstring("not refused"));
  }
  CHECK_THAT(file.refusal(file.bytes.substr(0, file.bytes.size() - 1)),
             ContainsSubstring("cut short") && ContainsSubstring("copy it again"));
  CHECK_THAT(file.refusal(file.bytes + "x"), ContainsSubstring("damaged"));
  CHECK_THAT(file.refusal("t,x,y\n0,1,2\n"), ContainsSubstring("not a saved state"));
  for (std::size_t at = 0; at < file.bytes.size(); at += 3) {
    auto damaged = file.bytes;
    damaged[at] = static_cast<char>(damaged[at] ^ 4);
    CAPTURE(at);
    REQUIRE(file.refusal(damaged) != "not refused");
  }
}

TEST_CASE("a state of another format, version, vector width or build is refused by name", "[continuation]") {
  const StateFile file;
  REQUIRE(file.refusal(file.with("stage", "stage1_bouncing")) == "not refused");
  auto format = file.bytes;
  format.replace(0, std::string("Clapotis state 1").size(), "Clapotis state 7");
  CHECK_THAT(file.refusal(format), ContainsSubstring("format 7") && ContainsSubstring("format 1"));
  CHECK_THAT(file.refusal(file.with("version", "Clapotis 9.9")),
             ContainsSubstring("Clapotis 9.9") && ContainsSubstring("run from the start"));
  CHECK_THAT(file.refusal(file.with("vector_width", 2 * static_cast<int>(pack_width))),
             ContainsSubstring(fmt::format("vectors of {}", 2 * pack_width)));
  CHECK_THAT(file.refusal(file.with("build", "0123456789abcdef")), ContainsSubstring("another build"));
  CHECK_THROWS_AS(read_state(file.path(), stage2::stage()), BadInput);
  CHECK_THROWS_AS(read_state(file.scratch / "nothing", file.stage), FileError);
  CHECK_THROWS_AS(read_state(file.scratch.path(), file.stage), FileError);
}
