#include <csignal>
#include <filesystem>
#include <nlohmann/json.hpp>
#include <thread>

#include "tests/common/programs.hpp"

// --save and --resume, seen from outside, on the real programs.

using namespace clapotis::testing;
using Catch::Matchers::ContainsSubstring;
using Json = nlohmann::json;
namespace fs = std::filesystem;

namespace {

Ended headless(const Scratch& scratch, const std::string& program, std::vector<std::string> arguments) {
  arguments.emplace_back("--headless");
  return run(scratch, program, arguments);
}

/// A bouncing disc saved after 100 steps.
void save_drop(const Scratch& scratch) {
  require_done(
      headless(scratch, stage1,
               {"drop", "--steps", "100", "--set", "drag=0.2", "--save", "drop.state", "--out", "first"}));
}

}  // namespace

TEST_CASE("a run in two parts leaves the files of one, wherever the first part ended", "[resume]") {
  const Scratch scratch;
  const std::vector<std::string> dam{"dam_break", "--set", "spacing=0.1", "--every", "0.01"};
  const auto part = [&](std::vector<std::string> more, bool resumed) {
    auto arguments = resumed ? std::vector<std::string>{"--every", "0.01"} : dam;
    arguments.insert(arguments.end(), more.begin(), more.end());
    require_done(headless(scratch, stage4, arguments));
  };
  part({"--until", "0.3", "--out", "whole"}, false);
  // 0.123 s is the end of no step: the state is that before the step which was shortened
  part({"--until", "0.123", "--save", "half.state", "--out", "first"}, false);
  part({"--resume", "half.state", "--until", "0.3", "--threads", "2", "--out", "second"}, true);
  CHECK(read(scratch / "second" / "final.csv") == read(scratch / "whole" / "final.csv"));
  const auto second = read(scratch / "second" / "series.csv"), whole = read(scratch / "whole" / "series.csv");
  const auto begins = second.find('\n') + 1;  // its first row is the state that it went on from
  const auto next = second.substr(second.find('\n', begins) + 1);
  CHECK(next.size() > 1000);
  CHECK(whole.ends_with(next));

  const auto json = Json::parse(read(scratch / "second" / "run.json"));
  const auto& from = json["resumed_from"];
  CHECK(from["file"] == "half.state");
  CHECK(from["simulated_seconds"].get<double>() < 0.123);
  CHECK(from["simulated_seconds"].get<double>() > 0.1);
  CHECK(json["steps"] == Json::parse(read(scratch / "whole" / "run.json"))["steps"]);
  CHECK(json["parameters"]["spacing"]["value"] == 0.1);
  CHECK(Json::parse(read(scratch / "whole" / "run.json"))["resumed_from"].is_null());
  CHECK(Json::parse(read(scratch / "first" / "run.json"))["saved"] == from);
  CHECK_THAT(headless(scratch, stage4, {"--config", "second/run.json", "--steps", "1", "--out", "again"}).err,
             ContainsSubstring("begins at the start"));
}

TEST_CASE("a run that was interrupted goes on from where it was", "[resume]") {
  const Scratch scratch;
  Process process(scratch, stage2,
                  {"cloud", "--headless", "--until", "1e6", "--set", "particles=60", "--save", "cloud.state",
                   "--out", "first"});
  for (int k = 0; k < 600 && !fs::exists(scratch / "first" / "run.json"); ++k)
    std::this_thread::sleep_for(std::chrono::milliseconds(20));
  process.send(SIGINT);
  CHECK(process.wait().code == 130);
  const auto steps = Json::parse(read(scratch / "first" / "run.json"))["steps"].get<long>();
  const auto end = std::to_string(steps + 50);
  require_done(headless(scratch, stage2, {"--resume", "cloud.state", "--steps", end, "--out", "second"}));
  require_done(
      headless(scratch, stage2, {"cloud", "--set", "particles=60", "--steps", end, "--out", "whole"}));
  CHECK(read(scratch / "second" / "final.csv") == read(scratch / "whole" / "final.csv"));
}

TEST_CASE("what is given beside a state agrees with it, or may change while a scene runs", "[resume]") {
  const Scratch scratch;
  save_drop(scratch);
  const auto resumed = [&](const std::vector<std::string>& more) {
    std::vector<std::string> arguments{"--resume", "drop.state", "--force", "--out", "r", "--steps", "120"};
    arguments.insert(arguments.end(), more.begin(), more.end());
    return headless(scratch, stage1, arguments);
  };
  require_done(resumed({"drop", "--set", "drag=0.2"}));
  require_done(resumed({"--set", "gravity=3"}));
  const auto changed = Json::parse(read(scratch / "r" / "run.json"));
  CHECK(changed["parameters"]["gravity"] == Json{{"value", 3.0}, {"unit", "m/s^2"}, {"origin", "flag"}});
  CHECK(changed["parameters"]["drag"]["value"] == 0.2);
  CHECK(changed["reference"].is_null());
  require_done(resumed({"--integrator", "rk4"}));
  CHECK(Json::parse(read(scratch / "r" / "run.json"))["integrator"] == "rk4");

  const auto refused = [&](const std::vector<std::string>& more, const std::string& sentence) {
    const auto ended = resumed(more);
    CHECK(ended.code == 2);
    CHECK_THAT(ended.err, ContainsSubstring(sentence));
  };
  refused({"--set", "y0=2"}, "y0 = 2 contradicts drop.state");
  refused({"bounce"}, "drop.state is of scene drop, not of bounce");
  refused({"--set", "gravty=2"}, "did you mean gravity?");
  refused({"--config", "first/run.json"}, "--resume and --config");
  refused({"--steps", "100"}, "step 100, already: --steps must be beyond");
  CHECK_THAT(headless(scratch, stage2, {"--resume", "drop.state"}).err,
             ContainsSubstring("drop.state is of stage1_bouncing, and this program is stage2_cloud"));
}

TEST_CASE("a state that cannot be resumed ends with 4 before anything is written", "[resume]") {
  const Scratch scratch;
  save_drop(scratch);
  const auto refused = [&](const std::string& program, const std::string& sentence) {
    const auto ended = headless(scratch, program, {"--resume", "drop.state", "--until", "9", "--out", "r"});
    CHECK(ended.code == 4);
    CHECK_THAT(ended.err, ContainsSubstring(sentence));
    CHECK_FALSE(fs::exists(scratch / "r"));
  };
  const auto other_build = scratch / "stage1_bouncing";
  write(other_build, read(stage1) + "more");
  fs::permissions(other_build, fs::perms::owner_all);
  refused(other_build.string(), "another build");
  const auto whole = read(scratch / "drop.state");
  write(scratch / "drop.state", whole.substr(0, whole.size() - 9));
  refused(stage1, "cut short");
  write(scratch / "drop.state", whole);
  require_done(headless(scratch, stage1, {"--resume", "drop.state", "--until", "2", "--out", "r"}));
}

TEST_CASE("a state that cannot be written is refused before the run, which a window never saves by option",
          "[resume]") {
  const Scratch scratch;
  const auto ended =
      headless(scratch, stage1, {"--until", "1", "--save", "no/such/folder/a.state", "--out", "r"});
  CHECK(ended.code == 4);
  CHECK_FALSE(fs::exists(scratch / "r"));
  const auto window = run(scratch, stage1, {"--save", "a.state"});
  CHECK(window.code == 2);
  CHECK_THAT(window.err, ContainsSubstring("--save is for a run without a window"));
}

TEST_CASE("a state that cannot be written at the end ends the run with 4, and all else is kept", "[resume]") {
  const Scratch scratch;
  fs::create_directory(scratch / "kept");
  Process process(
      scratch, stage1,
      {"bounce", "--headless", "--until", "1e9", "--every", "1e6", "--save", "kept/a.state", "--out", "r"});
  for (int k = 0; k < 600 && !fs::exists(scratch / "r" / "run.json"); ++k)
    std::this_thread::sleep_for(std::chrono::milliseconds(20));
  fs::remove(scratch / "kept");
  process.send(SIGINT);
  const auto ended = process.wait();
  CHECK(ended.code == 4);
  CHECK_THAT(ended.err, ContainsSubstring("cannot write kept/a.state"));
  CHECK(fs::exists(scratch / "r" / "final.csv"));
  const auto json = Json::parse(read(scratch / "r" / "run.json"));
  CHECK(json["stop_reason"] == "interrupted");
  CHECK(json["saved"].is_null());
}
