#include <algorithm>
#include <chrono>
#include <cmath>
#include <csignal>
#include <thread>

#include "common/runner/cadence.hpp"
#include "tests/catch.hpp"
#include "tests/common/programs.hpp"
#include "tests/common/run_files.hpp"

// What a headless run leaves behind, whatever ends it; seen from outside, on the real programs.

using namespace clapotis::testing;
using Catch::Matchers::ContainsSubstring;
using Json = nlohmann::json;
namespace fs = std::filesystem;

namespace {

bool has_parts(const fs::path& folder) {
  for (const auto& entry : fs::recursive_directory_iterator(folder))
    if (entry.path().extension() == ".part") return true;
  return false;
}

/// A run of a minute and more, which has begun to write.
Process long_run(const Scratch& scratch, const std::string& folder) {
  Process process(scratch, stage1,
                  {"bounce", "--headless", "--until", "1e9", "--every", "1", "--out", folder});
  for (int k = 0; k < 600 && !fs::exists(scratch / folder / "run.json"); ++k)
    std::this_thread::sleep_for(std::chrono::milliseconds(50));
  std::this_thread::sleep_for(std::chrono::milliseconds(1500));
  return process;
}

}  // namespace

TEST_CASE("a cadence is due at the first step at or after each multiple, rounding forgiven", "[runner]") {
  clapotis::Cadence cadence(0.1);
  const double dt = 0.01;
  double t = 0;
  long times = 0;
  for (int k = 1; k <= 1000; ++k) {
    t += dt;  // a hundred sums of 0.01 are not 1
    if (!cadence.due(t, dt)) continue;
    cadence.serve(t, dt);
    CHECK(k % 10 == 0);
    ++times;
  }
  CHECK(times == 100);
}

TEST_CASE("a run leaves its folder: what it was, its series, its last state, its picture", "[runner]") {
  const Scratch scratch;
  require_done(
      run(scratch, stage1,
          {"drop", "--headless", "--until", "1", "--out", "r", "--picture", "also.svg", "--frames", "0.25"}));
  for (const auto* name :
       {"run.json", "series.csv", "final.csv", "picture.png", "frames/0000.csv", "frames/0004.csv"})
    CHECK(fs::exists(scratch / "r" / name));
  CHECK_FALSE(fs::exists(scratch / "r" / "frames" / "0005.csv"));
  CHECK(fs::exists(scratch / "also.svg"));
  CHECK_FALSE(has_parts(scratch.path()));

  const auto run_json = json(scratch / "r" / "run.json");
  for (const auto* key : {"stage",
                          "scene",
                          "parameters",
                          "integrator",
                          "seed",
                          "threads",
                          "version",
                          "compiler",
                          "cpu",
                          "steps",
                          "force_evaluations",
                          "simulated_seconds",
                          "wall_seconds",
                          "cpu_seconds",
                          "particle_updates_per_second",
                          "cost",
                          "bytes_per_particle",
                          "peak_memory_bytes",
                          "reference",
                          "stop_reason",
                          "units",
                          "warnings",
                          "energy"})
    CHECK(run_json.contains(key));
  CHECK(run_json["simulated_seconds"] == 1.0);
  CHECK(run_json["stop_reason"] == "until");
  CHECK(run_json["parameters"]["gravity"] == Json{{"value", 9.81}, {"unit", "m/s^2"}, {"origin", "scene"}});
  CHECK(run_json["reference"]["error"].get<double>() < 1e-5);
  CHECK(run_json["cpu_seconds"].get<double>() < run_json["wall_seconds"].get<double>());

  const auto series = table(scratch / "r" / "series.csv");
  CHECK(series.header.size() == run_json["units"]["series.csv"].size());
  CHECK(series.at(0, "t") == 0);
  CHECK(series.last("t") == 1);
  CHECK(series.last("step") == run_json["steps"].get<double>());
  CHECK(series.last("total_energy") == run_json["energy"]["end"]["total"].get<double>());
  CHECK(series.last("error") == run_json["reference"]["error"].get<double>());
}

TEST_CASE("a column without meaning in the scene is absent", "[runner]") {
  const Scratch scratch;
  require_done(run(scratch, stage1, {"bounce", "--headless", "--steps", "3", "--out", "one"}));
  require_done(run(scratch, stage2, {"cloud", "--headless", "--steps", "3", "--out", "many"}));
  CHECK_THAT(read(scratch / "one" / "series.csv"),
             !ContainsSubstring("elastic_energy") && !ContainsSubstring("error"));
  CHECK_THAT(read(scratch / "many" / "series.csv"), ContainsSubstring("elastic_energy"));
}

TEST_CASE("the written acceleration is that of the written position and velocity: -g - beta v/m",
          "[runner]") {
  const Scratch scratch;
  for (const std::string integrator : {"explicit_euler", "velocity_verlet", "rk4"}) {
    require_done(run(scratch, stage1,
                     {"bounce", "--headless", "--until", "0.3", "--integrator", integrator, "--force",
                      "--set", "mass=2", "--set", "drag=0.5", "--out", "r"}));
    const auto last = table(scratch / "r" / "final.csv");
    REQUIRE(last.rows.size() == 1);
    CHECK(last.rows[0][1] == "disc");
    // both sides are one rounding of the same two numbers
    CHECK(last.at(0, "ax") == Approx(-0.25 * last.at(0, "vx")).epsilon(1e-15));
    CHECK(last.at(0, "ay") == Approx(-500 - 0.25 * last.at(0, "vy")).epsilon(1e-15));
  }
}

TEST_CASE("particles are written by id, with digits that read back as the same bits", "[runner]") {
  const Scratch scratch;
  require_done(run(scratch, stage2, {"cloud", "--headless", "--steps", "50", "--out", "r"}));
  const auto last = table(scratch / "r" / "final.csv");
  REQUIRE(last.rows.size() == 500);
  for (std::size_t i = 0; i < last.rows.size(); ++i) {
    REQUIRE(last.at(i, "id") == static_cast<double>(i));
    REQUIRE(last.rows[i][2].size() >= std::string("1.2345678901234567e+00").size());
  }
}

TEST_CASE("the walls of a tank are written after the water, at rest, with the pressure that they bear",
          "[runner]") {
  const Scratch scratch;
  require_done(run(scratch, stage4,
                   {"still_water", "--headless", "--steps", "3", "--set", "spacing=0.1", "--out", "r"}));
  const auto last = table(scratch / "r" / "final.csv");
  REQUIRE(last.rows.size() > 100);
  std::size_t water = 0;
  double deepest = 0;
  for (std::size_t i = 0; i < last.rows.size(); ++i) {
    REQUIRE(last.at(i, "id") == static_cast<double>(i));
    REQUIRE(last.rows[i].size() == last.header.size());
    if (last.rows[i][1] == "fluid") {
      REQUIRE(water == i);
      ++water;
      continue;
    }
    REQUIRE(last.rows[i][1] == "wall");
    for (const auto* column : {"vx", "vy", "ax", "ay"}) REQUIRE(last.at(i, column) == 0);
    const double x = last.at(i, "x"), y = last.at(i, "y");
    REQUIRE((x < 0 || x > 1 || y < 0));  // outside the tank
    REQUIRE(last.at(i, "density") > 0);
    if (x > 0.3 && x < 0.7 && y > -0.1) deepest = std::max(deepest, last.at(i, "pressure"));
  }
  CHECK(water == 100);
  CHECK(deepest == Approx(1000 * 9.81 * 1.05).epsilon(0.05));  // half a spacing below the floor
}

TEST_CASE("energies and momenta of a liquid are per unit of depth, in every file", "[runner]") {
  const Scratch scratch;
  const auto ended =
      run(scratch, stage4, {"--headless", "--steps", "3", "--set", "spacing=0.1", "--out", "r"});
  require_done(ended);
  const auto units = json(scratch / "r" / "run.json")["units"];
  CHECK(units["energy"] == "kg m/s^2");
  CHECK(units["series.csv"]["total_energy"] == "kg m/s^2");
  CHECK(units["series.csv"]["internal_energy"] == "kg m/s^2");
  CHECK(units["series.csv"]["momentum_x"] == "kg/s");
  CHECK_FALSE(units["series.csv"].contains("elastic_energy"));
  CHECK_THAT(ended.out, ContainsSubstring("J/m") && ContainsSubstring("real time"));
}

TEST_CASE("the run.json of a run replays it to the same bytes", "[runner]") {
  const Scratch scratch;
  struct Kind {
    std::string program;
    std::vector<std::string> arguments;
  };
  const Kind kinds[] = {
      {stage1, {"drop", "--until", "0.7", "--integrator", "rk2", "--set", "drag=0.1"}},
      {stage2, {"cloud", "--steps", "40", "--seed", "7", "--set", "particles=60", "--set", "dt=0.0007"}},
      {stage2, {"pair", "--until", "0.4", "--set", "mass_ratio=3"}},
      {stage3, {"cloud", "--until", "0.2", "--threads", "2", "--set", "particles=90"}},
  };
  for (const auto& [program, arguments] : kinds) {
    auto first = arguments;
    first.insert(first.end(), {"--headless", "--force", "--out", "first"});
    require_done(run(scratch, program, first));
    require_done(
        run(scratch, program, {"--headless", "--config", "first/run.json", "--force", "--out", "again"}));
    for (const auto* name : {"final.csv", "series.csv"})
      CHECK(read(scratch / "first" / name) == read(scratch / "again" / name));
    CHECK_FALSE(read(scratch / "first" / "final.csv").empty());
  }
}

TEST_CASE("how often a run is written down does not change it", "[runner]") {
  const Scratch scratch;
  const std::vector<std::string> what{"cloud", "--headless", "--until", "0.5", "--set", "particles=80"};
  const auto with = [&](const std::string& folder, std::vector<std::string> more) {
    auto arguments = what;
    arguments.insert(arguments.end(), more.begin(), more.end());
    arguments.insert(arguments.end(), {"--out", folder});
    require_done(run(scratch, stage2, arguments));
    return read(scratch / folder / "final.csv");
  };
  const auto rarely = with("rarely", {"--every", "1"});
  CHECK(rarely == with("often", {"--every", "1e-9"}));
  CHECK(rarely == with("frames", {"--frames", "0.003"}));
  CHECK(table(scratch / "rarely" / "series.csv").rows.size() == 2);
}

TEST_CASE("an earlier run is replaced only with --force, and nothing else in its folder is touched",
          "[runner]") {
  const Scratch scratch;
  require_done(run(scratch, stage1, {"--headless", "--steps", "9", "--frames", "1e-9", "--out", "r"}));
  write(scratch / "r" / "notes.txt", "mine");
  CHECK(run(scratch, stage1, {"--headless", "--steps", "3", "--out", "r"}).code == 4);
  CHECK(json(scratch / "r" / "run.json")["steps"] == 9);
  require_done(run(scratch, stage1, {"--headless", "--steps", "3", "--out", "r/", "--force"}));
  CHECK(json(scratch / "r" / "run.json")["steps"] == 3);
  CHECK_FALSE(fs::exists(scratch / "r" / "frames"));
  CHECK(read(scratch / "r" / "notes.txt") == "mine");
}

TEST_CASE("without --out each run has a folder of its own, also within one second", "[runner]") {
  const Scratch scratch;
  for (int k = 0; k < 3; ++k) require_done(run(scratch, stage1, {"--headless", "--steps", "1"}));
  CHECK(std::distance(fs::directory_iterator(scratch / "runs"), fs::directory_iterator()) == 3);
  for (const auto& entry : fs::directory_iterator(scratch / "runs"))
    CHECK(entry.path().filename().string().starts_with("stage1_bouncing-bounce-"));
}

TEST_CASE("Ctrl-C ends a run with 130 and keeps what was computed, which can be replayed", "[runner]") {
  const Scratch scratch;
  for (const int signal : {SIGINT, SIGTERM}) {
    const auto folder = "r" + std::to_string(signal);
    auto process = long_run(scratch, folder);
    process.send(signal);
    const auto ended = process.wait();
    INFO(ended.err);
    CHECK(ended.code == 130);
    CHECK_THAT(ended.err, ContainsSubstring("interrupted"));
    const auto result = json(scratch / folder / "run.json");
    CHECK(result["stop_reason"] == "interrupted");
    CHECK(result["steps"].get<long>() > 0);
    CHECK(table(scratch / folder / "series.csv").last("step") == result["steps"].get<double>());
    CHECK_FALSE(has_parts(scratch / folder));
    require_done(
        run(scratch, stage1, {"--headless", "--config", folder + "/run.json", "--out", folder + "again"}));
    CHECK(read(scratch / folder / "final.csv") == read(scratch / (folder + "again") / "final.csv"));
  }
}

TEST_CASE("a run that is killed leaves no half file: its series is a part, its run.json says that it ran",
          "[runner]") {
  const Scratch scratch;
  auto process = long_run(scratch, "r");
  process.send(SIGKILL);
  CHECK(process.wait().code == 128 + SIGKILL);
  CHECK(json(scratch / "r" / "run.json")["stop_reason"] == "running");
  CHECK_FALSE(fs::exists(scratch / "r" / "series.csv"));
  CHECK_FALSE(fs::exists(scratch / "r" / "final.csv"));
  CHECK(table(scratch / "r" / "series.csv.part").rows.size() > 10);
  require_done(run(scratch, stage1, {"--headless", "--steps", "3", "--out", "r", "--force"}));
  CHECK_FALSE(has_parts(scratch / "r"));
}

TEST_CASE("a run that diverges ends with 5, keeps its last good state, and says why", "[runner]") {
  const Scratch scratch;
  const auto ended = run(scratch, stage2, {"cloud", "--headless", "--set", "dt=0.02", "--out", "r"});
  INFO(ended.err);
  CHECK(ended.code == 5);
  CHECK_THAT(ended.err, ContainsSubstring("diverged at step"));
  const auto result = json(scratch / "r" / "run.json");
  CHECK(result["stop_reason"] == "diverged");
  CHECK_THAT(result["stop_message"].get<std::string>(), ContainsSubstring("contact limit"));
  const auto last = table(scratch / "r" / "final.csv");
  for (std::size_t i = 0; i < last.rows.size(); ++i) REQUIRE(std::isfinite(last.at(i, "vy")));
  CHECK(table(scratch / "r" / "series.csv").last("step") == result["steps"].get<double>());
}

TEST_CASE("a full disk ends a run with 4 and the name of the file, never with half a file", "[runner]") {
  const Scratch scratch;
  const auto ended =
      run(scratch, stage1, {"--headless", "--until", "1", "--out", "r"}, {.largest_file = 20000});
  INFO(ended.err);
  CHECK(ended.code == 4);
  CHECK_THAT(ended.err, ContainsSubstring("cannot write r/series.csv: File too large"));
  CHECK_FALSE(fs::exists(scratch / "r" / "series.csv"));
  const auto told = run(scratch, stage1, {"--headless", "--steps", "1", "--out", "s"}, {.out = "/dev/full"});
  CHECK(told.code == 4);
  CHECK_THAT(told.err, ContainsSubstring("cannot write standard output: No space left"));
  CHECK(fs::exists(scratch / "s" / "final.csv"));
}

TEST_CASE("standard output is for results: a summary, run.json, or nothing", "[runner]") {
  const Scratch scratch;
  const auto people = run(scratch, stage1, {"drop", "--headless", "--until", "1", "--out", "a"});
  CHECK_THAT(people.out, ContainsSubstring("a: done at t = 1 s") && ContainsSubstring("closed"));
  CHECK(people.err.empty());
  const auto program = run(scratch, stage1, {"drop", "--headless", "--until", "1", "--out", "b", "--json"});
  CHECK(Json::parse(program.out) == json(scratch / "b" / "run.json"));
  const auto nobody = run(scratch, stage1, {"drop", "--headless", "--until", "1", "--out", "c", "--quiet"});
  CHECK(nobody.out.empty());
  CHECK(nobody.err.empty());
}

TEST_CASE("a run of no step leaves the start as its end", "[runner]") {
  const Scratch scratch;
  require_done(run(scratch, stage1, {"drop", "--headless", "--steps", "0", "--out", "r"}));
  CHECK(table(scratch / "r" / "series.csv").rows.size() == 1);
  CHECK(table(scratch / "r" / "final.csv").at(0, "y") == 1);
}

TEST_CASE("probes are columns of the series, and a run is repeated with them from its run.json", "[runner]") {
  const Scratch scratch;
  const auto ended = run(scratch, stage5,
                         {"sloshing", "--headless", "--steps", "3", "--out", "once", "--quiet", "--set",
                          "spacing=0.05", "--set", "probe_x=0.25,0.5", "--set", "probe_y=0.1"});
  INFO(ended.err);
  REQUIRE(ended.code == 0);
  const auto once = table(scratch / "once" / "series.csv");
  for (const auto* column : {"elevation_0.25", "elevation_0.5", "pressure_left_0.1", "pressure_right_0.1"})
    CHECK(std::count(once.header.begin(), once.header.end(), column) == 1);
  CHECK(once.at(0, "pressure_left_0.1") == Approx(1000 * 9.81 * 0.4).epsilon(0.01));
  const auto again =
      run(scratch, stage5, {"--headless", "--config", "once/run.json", "--out", "again", "--quiet"});
  INFO(again.err);
  REQUIRE(again.code == 0);
  CHECK(read(scratch / "once" / "series.csv") == read(scratch / "again" / "series.csv"));
}
