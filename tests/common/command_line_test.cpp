#include <algorithm>
#include <sstream>
#include <string>
#include <vector>

#include "tests/catch.hpp"
#include "tests/common/process.hpp"

// The stage programs as their user meets them: as processes. What they cannot use, they say in one sentence.

using namespace clapotis::testing;
using Catch::Matchers::ContainsSubstring;

namespace {

const std::string stage1 = STAGE1_PROGRAM, stage2 = STAGE2_PROGRAM, stage5 = STAGE5_PROGRAM,
                  compare = COMPARE_PROGRAM;

struct Case {
  std::vector<std::string> arguments;
  int code;
  std::string sentence;  ///< a part of what must be said
};

void check(const std::string& program, const Case& c, const Scratch& scratch, const Start& start = {}) {
  const auto ended = run(scratch, program, c.arguments, start);
  std::string line;
  for (const auto& argument : c.arguments) line += ' ' + argument;
  INFO(program << line << "\n" << ended.err);
  CHECK(ended.code == c.code);
  CHECK_THAT(ended.err, ContainsSubstring(c.sentence));
  CHECK(ended.err.starts_with(std::filesystem::path(program).filename().string() + ": "));
  CHECK(std::count(ended.err.begin(), ended.err.end(), '\n') == 1);
  CHECK(ended.out.empty());
  CHECK_FALSE(std::filesystem::exists(scratch / "runs"));
}

}  // namespace

TEST_CASE("a word that names nothing is refused with the nearest that does", "[runner]") {
  const Scratch scratch;
  const Case cases[] = {
      {{"--headless", "boune"}, 2, "did you mean bounce?"},
      {{"--headless", "--untl", "3"}, 2, "did you mean --until?"},
      {{"--headless", "--set", "gravty=3"}, 2, "did you mean gravity?"},
      {{"--headless", "--set", "impacts=clmp"}, 2, "did you mean clamp?"},
      {{"--headless", "--integrator", "verlet"}, 2, "did you mean velocity_verlet?"},
      {{"--headless", "--gravity", "3"}, 2, "--set gravity=VALUE"},
      {{"--headless", "--gravty=3"}, 2, "--set gravity=VALUE"},
      {{"--list", "parameter"}, 2, "did you mean parameters?"},
      {{"--list", "kernels"}, 2, "scenes, parameters, integrators"},
      {{"--headless", "bounce", "drop"}, 2, "one scene at a time"},
      {{"--video", "film.mp4"}, 2, "--video is for a run without a window"},
      {{"--resume", "no.state"}, 4, "cannot read no.state"},
      {{"--headless", "--vdeo=f.mp4"}, 2, "did you mean --video?"},
      {{"--headless", "--vtk", "0"}, 2, "vtk must be > 0 s"},
      {{"--headless", "--theme", "drak"}, 2, "did you mean dark?"},
      {{"--lang", "de"}, 2, "lang = de is not one of: en, fr"},
      {{"--langue", "fr"}, 2, "did you mean --lang?"},
      {{"-x"}, 2, "no option -x"},
  };
  for (const auto& c : cases) check(stage1, c, scratch);
}

TEST_CASE("a value that cannot be used is refused before anything runs", "[runner]") {
  const Scratch scratch;
  const auto set = [](const std::string& text) {
    return std::vector<std::string>{"--headless", "--set", text};
  };
  const Case cases[] = {
      {set("gravity"), 2, "--set NAME=VALUE"},
      {set("=3"), 2, "--set NAME=VALUE"},
      {set(""), 2, "--set NAME=VALUE"},
      {set("gravity="), 2, "not a finite number"},
      {set("gravity=nan"), 2, "not a finite number"},
      {set("gravity=inf"), 2, "not a finite number"},
      {set("gravity=-inf"), 2, "not a finite number"},
      {set("gravity=1e999"), 2, "not a finite number"},
      {set("gravity=9.81m"), 2, "not a finite number"},
      {set("gravity= 3"), 2, "not a finite number"},
      {set("gravity=9,81"), 2, "with a dot"},
      {set("mass=-1"), 2, "mass must be > 0 kg"},
      {set("mass=0"), 2, "mass must be > 0 kg"},
      {set("radius=0"), 2, "radius must be > 0"},
      {set("dt=0"), 2, "dt must be > 0 s, or auto"},
      {set("dt=-1e-3"), 2, "dt must be > 0 s, or auto"},
      {set("restitution=1.5"), 2, "between 0 and 1"},
      {set("vx0=1e300"), 2, "dt = auto comes out as 0 s from the acoustic limit h/c"},
      {set("dt=1e-300"), 2, "beyond the 1e+15 that can be counted"},
      {{"--headless", "--until", "1e300"}, 2, "take a larger dt or a smaller until"},
      {{"--headless", "--until", "nan"}, 2, "not a finite number"},
      {{"--headless", "--until", "-1"}, 2, "until must be >= 0 s"},
      {{"--headless", "--until", "1,5"}, 2, "with a dot"},
      {{"--headless", "--until"}, 2, "--until needs a value"},
      {{"--headless", "--until", "--steps", "3"}, 2, "--until needs a value"},
      {{"--headless", "--steps", "1.5"}, 2, "not a whole number"},
      {{"--headless", "--steps", "-1"}, 2, "out of range"},
      {{"--headless", "--every", "0"}, 2, "every must be > 0 s"},
      {{"--headless", "--frames", "-1"}, 2, "frames must be > 0 s"},
      {{"--headless", "--threads", "0"}, 2, "between 1 and 1024"},
      {{"--headless", "--threads", "two"}, 2, "not a finite number"},
      {{"--headless", "--set"}, 2, "--set needs a value"},
      {{"--headless", "--json=3"}, 2, "--json takes no value"},
      {{"--headless", "--seed", "3"}, 2, "nothing to chance"},
      {{"--headless", "--picture", "wave.jpg"}, 2, ".png, .svg or .pdf"},
      {{"--scale", "100"}, 2, "between 0.25 and 8"},
      {{"--out", "folder"}, 2, "add --headless"},
      {{"--json"}, 2, "add --headless"},
  };
  for (const auto& c : cases) check(stage1, c, scratch);
  const Case of_many[] = {
      {set("particles=0"), 2, "particles must be"},
      {set("particles=1.5"), 2, "not a whole number"},
      {set("particles=1000000"), 2, "do not fit"},
      {set("seed=-1"), 2, "seed must be"},
  };
  for (const auto& c : of_many) check(stage2, c, scratch);
}

TEST_CASE("a file that cannot be used is refused with its name, the line or the key", "[runner]") {
  const Scratch scratch;
  const auto with = [&](const std::string& text) {
    write(scratch / "lab.json", text);
    return std::vector<std::string>{"--headless", "--config", "lab.json"};
  };
  check(stage1, {with(R"({"scen": "drop"})"), 2, "lab.json: there is no key scen; did you mean scene?"},
        scratch);
  check(stage1, {with("{\n\"scene\": \"drop\",\n oops\n}"), 2, "lab.json, line 3: this is not JSON"},
        scratch);
  check(stage1, {with(""), 2, "this is not JSON"}, scratch);
  check(stage1, {with("[1, 2]"), 2, "cannot be [1,2]"}, scratch);
  check(stage1, {with(R"({"parameters": {"gravty": 3}})"), 2, "did you mean gravity?"}, scratch);
  check(stage1, {with(R"({"parameters": {"gravity": "3,5"}})"), 2, "with a dot"}, scratch);
  check(stage1, {with(R"({"parameters": {"gravity": null}})"), 2, "gravity cannot be null"}, scratch);
  check(stage1, {with(R"({"parameters": {"gravity": 1e999}})"), 2, "this is not JSON"}, scratch);
  check(stage1, {with(R"({"parameters": {"gravity": {"valu": 3}}})"), 2, "did you mean value?"}, scratch);
  check(stage1, {with(R"({"parameters": {"gravity": {"unit": "m"}}})"), 2, "gravity has no value"}, scratch);
  check(stage1, {with(R"({"parameters": 3})"), 2, "parameters cannot be 3"}, scratch);
  check(stage1, {with(R"({"until": 1, "until": 2})"), 2, "until is given twice"}, scratch);
  check(stage1, {with(R"({"until": true})"), 2, "until cannot be true"}, scratch);
  check(stage1, {with(R"({"parameters": {"gravity": -3}})"), 2, "lab.json: gravity = -3 px/s^2 is out of"},
        scratch);
  check(stage1, {with(R"({"threads": 0})"), 2, "lab.json: threads = 0 is out of range"}, scratch);
  check(stage1,
        {with(R"({"scene": "drop", "parameters": {"gravity": {"value": 500, "unit": "px/s^2"}}})"), 2,
         "lab.json: gravity = 500 is in px/s^2, but this scene's gravity is in m/s^2"},
        scratch);
  check(stage1, {with(R"({"stage": "stage2_cloud"})"), 2, "is of stage2_cloud"}, scratch);
  check(stage1, {with(R"({"scene": "dorp"})"), 2, "did you mean drop?"}, scratch);
  check(stage1, {with(R"({"steps": 1.5})"), 2, "not a whole number"}, scratch);
  check(stage1, {with(R"({"stop_reason": 3, "stop": 4})"), 2, "stop cannot be 4"}, scratch);
  check(stage1, {{"--config", "nowhere.json"}, 4, "cannot read nowhere.json: No such file"}, scratch);
  check(stage1, {{"--config", "."}, 4, "Is a directory"}, scratch);
  check(stage1, {{"--config", "/dev/zero"}, 4, "too large"}, scratch);
}

TEST_CASE("a place where nothing can be written is refused with the system's reason", "[runner]") {
  const Scratch scratch;
  write(scratch / "file", "mine");
  std::filesystem::create_directory(scratch / "thesis");
  write(scratch / "thesis" / "chapter1.tex", "mine");
  const Case cases[] = {
      {{"--headless", "--out", "file"}, 4, "file exists and is not a folder"},
      {{"--headless", "--out", "file/run"}, 4, "cannot write file/run: "},
      {{"--headless", "--out", "/proc/run"}, 4, "cannot write /proc/run: "},
      {{"--headless", "--out", "thesis"}, 4, "--force"},
      {{"--headless", "--out", "thesis", "--force"}, 4, "holds no run.json"},
      {{"--headless", "--out", ""}, 2, "--out needs"},
      {{"--headless", "--picture", "nowhere/wave.png"}, 4, "cannot write nowhere/wave.png: "},
  };
  for (const auto& c : cases) check(stage1, c, scratch);
  CHECK(read(scratch / "thesis" / "chapter1.tex") == "mine");
}

TEST_CASE("without a display a stage says so, and how to run", "[runner]") {
  const Scratch scratch;
  const Start nowhere{.environment = {{"DISPLAY", ""}, {"WAYLAND_DISPLAY", ""}}};
  check(stage1, {{}, 3, "--headless"}, scratch, nowhere);
  check(stage1, {{"--set", "mass=-1"}, 2, "mass must be"}, scratch, nowhere);
}

TEST_CASE("a value comes from the flag, or else the environment, or else the file, or else the scene",
          "[runner]") {
  const Scratch scratch;
  write(scratch / "lab.json", R"({
    // comments are allowed
    "scene": "drop", "integrator": "rk2", "threads": 2,
    "parameters": {"gravity": 1.5, "drag": 0.25, "restitution": 0.5}
  })");
  const Start environment{.environment = {{"CLAPOTIS_GRAVITY", "3"}, {"CLAPOTIS_DRAG", "2"}}};
  const auto config = run(scratch, stage1,
                          {"--config", "lab.json", "--set", "gravity=4", "--set", "gravity=5", "--integrator",
                           "rk4", "--print-config"},
                          environment);
  INFO(config.out << config.err);
  CHECK(config.code == 0);
  const auto row = [&](const std::string& name) {
    std::istringstream lines(config.out);
    for (std::string line, first, value, unit, origin; std::getline(lines, line);) {
      std::istringstream(line) >> first >> value >> unit >> origin;
      if (first == name) return value + ' ' + unit + ' ' + origin;
    }
    return std::string("absent");
  };
  CHECK(row("gravity") == "5 m/s^2 flag");  // of one name given twice, the last
  CHECK(row("drag") == "2 kg/s environment");
  CHECK(row("restitution") == "0.5 - file");
  CHECK(row("height") == "1.2 m scene");
  CHECK(row("mass") == "1 kg default");
  CHECK(row("dt") == "auto s default");
  CHECK(row("scene") == "drop - file");
  CHECK(row("integrator") == "rk4 - flag");
  CHECK(row("threads") == "2 - file");
  CHECK(row("until") == "5 s default");
}

TEST_CASE("who says when to stop overrules both ways of saying it from a weaker origin", "[runner]") {
  const Scratch scratch;
  write(scratch / "lab.json", R"({"until": 0.5, "steps": 7})");
  const auto config = run(scratch, stage1, {"--config", "lab.json", "--steps", "3", "--print-config"});
  CHECK_THAT(config.out, ContainsSubstring("steps"));
  CHECK_THAT(config.out, !ContainsSubstring("until"));
}

TEST_CASE("the environment may speak of other scenes, that is said, and a wrong value is refused",
          "[runner]") {
  const Scratch scratch;
  const Start other{.environment = {{"CLAPOTIS_GRAVTY", "3"}}};
  const auto ended = run(scratch, stage1, {"--print-config"}, other);
  CHECK(ended.code == 0);
  CHECK_THAT(ended.err,
             ContainsSubstring("CLAPOTIS_GRAVTY is ignored") && ContainsSubstring("did you mean gravity?"));
  check(stage1, {{"--headless"}, 2, "with a dot"}, scratch, {.environment = {{"CLAPOTIS_GRAVITY", "9,81"}}});
  check(stage1, {{"--headless"}, 2, "CLAPOTIS_GRAVITY: gravity = -1"}, scratch,
        {.environment = {{"CLAPOTIS_GRAVITY", "-1"}}});
  check(stage1, {{"--headless"}, 2, "CLAPOTIS_THREADS: threads = x"}, scratch,
        {.environment = {{"CLAPOTIS_THREADS", "x"}}});
}

TEST_CASE("what --print-config prints as JSON is a file that --config takes", "[runner]") {
  const Scratch scratch;
  const auto first = run(scratch, stage2, {"pair", "--set", "mass_ratio=3", "--print-config", "--json"});
  write(scratch / "again.json", first.out);
  const auto second = run(scratch, stage2, {"--config", "again.json", "--print-config"});
  INFO(second.err);
  CHECK(second.code == 0);
  CHECK_THAT(second.out, ContainsSubstring("pair") && ContainsSubstring("mass_ratio"));
}

TEST_CASE("the lists name all there is, for people and for programs", "[runner]") {
  const Scratch scratch;
  CHECK(run(scratch, stage1, {"--list", "scenes"}).out == "bounce\ndrop\n");
  CHECK_THAT(run(scratch, stage1, {"--list", "integrators", "--json"}).out, ContainsSubstring("\"rk4\""));
  const auto all = run(scratch, stage1, {"--list", "parameters"}).out;
  CHECK_THAT(all,
             ContainsSubstring("bounce\n") && ContainsSubstring("drop\n") && ContainsSubstring("px/s^2"));
  const auto one = run(scratch, stage1, {"drop", "--list", "parameters"}).out;
  CHECK_THAT(one, !ContainsSubstring("bounce\n") && ContainsSubstring("m/s^2"));
  CHECK_THAT(run(scratch, stage1, {"--help"}).out,
             ContainsSubstring("--headless") && ContainsSubstring("Exit codes"));
  CHECK_THAT(run(scratch, stage1, {"--version"}).out, ContainsSubstring("Clapotis "));
}

TEST_CASE("a comparison refuses what cannot be compared", "[runner]") {
  const Scratch scratch;
  const Case cases[] = {
      {{"stage1/drop"}, 2, "not 1"},
      {{"drop", "stage1/drop"}, 2, "STAGE/SCENE"},
      {{"stage1/drop", "stage1/bounce"}, 2, "in m and in px"},
      {{"stag1/drop", "stage1/drop"}, 2, "did you mean stage1?"},
      {{"stage1/dorp", "stage1/drop"}, 2, "did you mean drop?"},
      {{"stage1/drop:gravty=3", "stage1/drop"}, 2, "did you mean gravity?"},
      {{"stage1/drop:gravity", "stage1/drop"}, 2, "not NAME=VALUE"},
      {{"stage1/drop:integrator=rk5", "stage1/drop"}, 2, "did you mean rk"},
      {{"stage1/drop", "stage1/drop", "--evry", "1"}, 2, "did you mean --every?"},
      {{"stage1/drop", "stage1/drop", "--until", "1", "--steps", "2"}, 2, "one of them"},
      {{"stage1/drop", "stage1/drop", "--until", "0"}, 2, "until must be > 0 s"},
      {{"stage1/drop", "stage1/drop:dt=1e-300", "--until", "1"}, 2, "beyond the 1e+15 that can be counted"},
      {{"stage1/drop", "stage1/drop", "--until", "0.1", "--out", "/proc/x"}, 4, "cannot write /proc/x"},
  };
  for (const auto& c : cases) check(compare, c, scratch);
}

TEST_CASE("a stage of liquids neither lists nor takes an integrator that advances no density", "[runner]") {
  const Scratch scratch;
  CHECK_THAT(run(scratch, stage1, {"--list", "integrators"}).out, ContainsSubstring("bogacki_shampine"));
  const auto listed = run(scratch, stage5, {"--list", "integrators"}).out;
  CHECK_THAT(listed, ContainsSubstring("rk4") && !ContainsSubstring("bogacki_shampine"));
  check(stage5,
        {{"--headless", "--integrator", "bogacki_shampine"},
         2,
         "one of explicit_euler, symplectic_euler, velocity_verlet, rk2, rk4"},
        scratch);
  const auto unknown = run(scratch, stage5, {"--integrator", "rk5"}).err;
  CHECK_THAT(unknown, ContainsSubstring("there is no integrator rk5") && !ContainsSubstring("bogacki"));
}

TEST_CASE("a list is an array in a file, text on the command line, and survives the way through both",
          "[runner]") {
  const Scratch scratch;
  const auto out = [&](std::vector<std::string> arguments) {
    arguments.emplace_back("--print-config");
    const auto ended = run(scratch, stage5, arguments);
    INFO(ended.err);
    CHECK(ended.code == 0);
    return ended.out;
  };
  const auto json = out({"sloshing", "--set", "probe_x=0.1,0.5", "--json"});
  CHECK_THAT(json, ContainsSubstring("\"value\": [\n        0.1,\n        0.5\n      ]"));
  write(scratch / "probes.json",
        R"({"scene": "sloshing", "parameters": {"probe_x": [0.25, 0.75], "probe_y": []}})");
  CHECK_THAT(out({"--config", "probes.json"}), ContainsSubstring("0.25,0.75") && ContainsSubstring("none"));
  write(scratch / "words.json", R"({"scene": "sloshing", "parameters": {"probe_x": ["left"]}})");
  check(stage5, {{"--config", "words.json", "--print-config"}, 2, "probe_x cannot be [\"left\"]"}, scratch);
}
