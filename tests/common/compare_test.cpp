// What a comparison of two scenes finds and leaves behind; seen from outside, on the real program.

#include <filesystem>

#include "tests/catch.hpp"
#include "tests/common/programs.hpp"
#include "tests/common/run_files.hpp"

using namespace clapotis::testing;
using Catch::Matchers::ContainsSubstring;
namespace fs = std::filesystem;

TEST_CASE("the grid and all pairs give one trajectory, compared after each step", "[runner]") {
  const Scratch scratch;
  require_done(run(scratch, compare,
                   {"stage2/cloud:particles=120", "stage3/cloud:particles=120,threads=2", "--until", "0.5",
                    "--out", "c"}));
  const auto result = json(scratch / "c" / "compare.json");
  CHECK(result["largest_difference"]["largest"] == 0.0);
  CHECK(result["left"]["steps"] == result["right"]["steps"]);
  CHECK(result["clock"] == "after each step of both");
  CHECK(fs::exists(scratch / "c" / "picture.png"));
  // a row for each step, and the start
  CHECK(table(scratch / "c" / "compare.csv").rows.size() == result["left"]["steps"].get<std::size_t>() + 1);
}

TEST_CASE("two time steps are compared at common instants, with the error of the schemes alone", "[runner]") {
  const Scratch scratch;
  // in free fall with drag RK4 is exact to far below the instants' cubic, whose error is dt^4 y''''/384:
  // 1e-14 here
  require_done(run(scratch, compare,
                   {"stage1/drop:integrator=rk4,dt=0.001", "stage1/drop:integrator=rk4,dt=0.0007", "--until",
                    "0.4", "--every", "0.01", "--out", "c"}));
  const auto result = json(scratch / "c" / "compare.json");
  CHECK(result["largest_difference"]["largest"].get<double>() < 1e-12);
  CHECK(table(scratch / "c" / "compare.csv").rows.size() == 41);
}

TEST_CASE("when one side diverges the other goes on, and that is said", "[runner]") {
  const Scratch scratch;
  const auto ended = run(
      scratch, compare,
      {"stage2/cloud:dt=0.02,particles=200", "stage2/cloud:particles=200", "--until", "1.5", "--out", "c"});
  INFO(ended.err);
  CHECK(ended.code == 0);
  CHECK_THAT(ended.err, ContainsSubstring("diverged at step"));
  const auto result = json(scratch / "c" / "compare.json");
  CHECK(result["left"]["diverged"] == true);
  CHECK(result["right"]["simulated_seconds"] == 1.5);
  CHECK(result["end_difference"].is_null());
  const auto rows = table(scratch / "c" / "compare.csv");
  CHECK(std::isnan(rows.last("largest_difference")));
  CHECK(rows.last("t") == 1.5);
}

TEST_CASE("two resolutions are compared by their errors, and it is said that places are not", "[runner]") {
  const Scratch scratch;
  require_done(run(scratch, compare,
                   {"stage4/dam_break:spacing=0.125", "stage4/dam_break:spacing=0.2", "--until", "0.3",
                    "--every", "0.05", "--out", "c"}));
  const auto result = json(scratch / "c" / "compare.json");
  CHECK(result["largest_difference"].is_null());
  CHECK_THAT(result["warnings"][0].get<std::string>(), ContainsSubstring("same particles, 128 and 50"));
  const auto rows = table(scratch / "c" / "compare.csv");
  CHECK(rows.rows.size() == 7);
  CHECK(std::isnan(rows.last("largest_difference")));
  CHECK(rows.last("left_error") > 0);
  CHECK(rows.last("right_error") > 0);
  CHECK(rows.last("right_total_energy") > 0);
}

TEST_CASE("particles that enter on one side alone end the comparison of places, not that of errors",
          "[runner]") {
  const Scratch scratch;
  require_done(run(scratch, compare,
                   {"stage5/channel:spacing=0.001", "stage5/channel:spacing=0.001,nu=0.002", "--until", "0.2",
                    "--every", "0.02", "--out", "c"}));
  const auto rows = table(scratch / "c" / "compare.csv");
  CHECK(rows.at(0, "largest_difference") > 0);
  CHECK(std::isnan(rows.last("largest_difference")));
  CHECK(rows.last("left_error") > 0);
  CHECK(rows.last("t") == 0.2);
}
