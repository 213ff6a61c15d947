// What a comparison of two scenes finds and leaves behind; seen from outside, on the real program.

#include <filesystem>

#include "tests/catch.hpp"
#include "tests/common/encoder.hpp"
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

TEST_CASE("the end is compared also where one step has passed the last row and the end", "[runner]") {
  const Scratch scratch;
  require_done(run(scratch, compare,
                   {"stage1/drop:integrator=rk4,dt=0.08", "stage1/drop:integrator=rk4,dt=0.03", "--until",
                    "0.4", "--every", "0.09", "--out", "c"}));
  const auto result = json(scratch / "c" / "compare.json");
  CHECK(result["end_difference"]["t"] == 0.4);
  CHECK(result["warnings"].empty());
  const auto rows = table(scratch / "c" / "compare.csv");
  CHECK(rows.rows.size() == 6);  // t = 0, 0.09, 0.18, 0.27, 0.36, 0.4
  CHECK(rows.last("t") == 0.4);
  CHECK(rows.last("largest_difference") < 1e-4);
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

TEST_CASE("a film shows both sides at equal steps of their common clock, and alters no row", "[runner]") {
  const Scratch scratch;
  const std::vector<std::string> sides{"stage1/drop:integrator=explicit_euler,dt=0.02", "stage1/drop:dt=0.03",
                                       "--until", "1"};
  const auto both = [&](const std::string& folder, std::vector<std::string> more) {
    auto arguments = sides;
    more.insert(more.end(), {"--out", folder});
    arguments.insert(arguments.end(), more.begin(), more.end());
    require_done(run(scratch, compare, arguments, with_encoder(scratch, keeps_all)));
  };
  both("alone", {});
  both("filmed", {"--video", "film.mp4", "--video-every", "0.125"});
  CHECK(read(scratch / "alone" / "compare.csv") == read(scratch / "filmed" / "compare.csv"));
  const Frames film(read(scratch / "film.mp4"));
  REQUIRE(film.size() == 9);  // t = 0, 0.125, ... 1
  const auto left = film.part(0, {20, 100, 600, 300}), right = film.part(0, {660, 100, 600, 300});
  CHECK(film.part(4, {20, 100, 600, 300}) != left);  // the particle falls in either half
  CHECK(film.part(4, {660, 100, 600, 300}) != right);
}

TEST_CASE("both sides of a film have one range of colours from its first frame to its last", "[runner]") {
  const Scratch scratch;
  require_done(run(scratch, compare,
                   {"stage2/cloud:particles=40", "stage3/cloud:particles=40,gravity=100", "--until", "0.6",
                    "--video", "film.mp4", "--video-every", "0.2", "--out", "c"},
                   with_encoder(scratch, keeps_all)));
  const Frames film(read(scratch / "film.mp4"));
  REQUIRE(film.size() == 4);
  for (std::size_t k = 1; k < film.size(); ++k) CHECK(film.part(k, legend) == film.part(0, legend));
}

TEST_CASE("in a film the slow side has dark colours when the other one is fast", "[runner]") {
  const Scratch scratch;
  require_done(run(scratch, compare,
                   {"stage1/drop:gravity=0.1", "stage1/drop:gravity=10", "--until", "0.2", "--video",
                    "film.mp4", "--video-every", "0.1", "--out", "c"},
                   with_encoder(scratch, keeps_all)));
  const Frames film(read(scratch / "film.mp4"));
  REQUIRE(film.size() == 3);
  const auto is_bright = [&](const Part& half) {  // the end of the colour map, yellow
    const auto pixels = film.part(2, half);
    bool found = false;
    for (std::size_t at = 0; at < pixels.size(); at += 4) {
      const auto value = [&](std::size_t byte) { return static_cast<unsigned char>(pixels[at + byte]); };
      found = found || (value(2) > 180 && value(1) > 180 && value(0) < 80);
    }
    return found;
  };
  CHECK_FALSE(is_bright({20, 170, 600, 300}));
  CHECK(is_bright({660, 170, 600, 300}));
}

TEST_CASE("a film goes on with the side that lives, and ends when neither does", "[runner]") {
  const Scratch scratch;
  const std::string dies = "stage2/cloud:dt=0.02,particles=200";
  const auto filmed = [&](const std::string& right) {
    return run(scratch, compare,
               {dies, right, "--until", "1.5", "--video", "film.mp4", "--video-every", "0.25", "--force",
                "--out", "c"},
               with_encoder(scratch, keeps_all));
  };
  require_done(filmed("stage2/cloud:particles=200"));
  CHECK(Frames(read(scratch / "film.mp4")).size() == 7);
  CHECK(filmed(dies + ",seed=2").code == 5);
  const auto frames = Frames(read(scratch / "film.mp4")).size();
  CHECK(frames > 1);
  CHECK(frames < 7);
}

TEST_CASE("without an ffmpeg, or under a name that is no film's, nothing is compared", "[runner]") {
  const Scratch scratch;
  std::filesystem::create_directory(scratch / "empty");
  const auto refused = [&](const std::vector<std::string>& more, int code, const std::string& sentence) {
    std::vector<std::string> arguments{"stage1/drop", "stage1/drop", "--out", "c"};
    arguments.insert(arguments.end(), more.begin(), more.end());
    const auto ended =
        run(scratch, compare, arguments, {.environment = {{"PATH", (scratch / "empty").string()}}});
    CHECK(ended.code == code);
    CHECK_THAT(ended.err, ContainsSubstring(sentence));
    CHECK_FALSE(fs::exists(scratch / "c"));
  };
  refused({"--video", "film.mp4"}, 4, "there is no ffmpeg to make film.mp4 with: install it");
  refused({"--video", "film.mp4", "--lang", "fr"}, 4, "film.mp4");
  refused({"--video", "film.avi"}, 2, "film.avi: the name must end in .mp4");
  refused({"--video", "no/folder/film.mp4"}, 4, "cannot write no/folder/film.mp4");
  refused({"--video-every", "0.1"}, 2, "--video-every has no meaning without --video");
}

TEST_CASE("when ffmpeg gives up, the comparison goes on, leaves all else, and ends with 4", "[runner]") {
  const Scratch scratch;
  const auto ended = run(
      scratch, compare,
      {"stage1/drop:dt=0.02", "stage1/drop:dt=0.01", "--until", "0.5", "--video", "film.mp4", "--out", "c"},
      with_encoder(scratch, "echo 'no such encoder' >&2; exit 3"));
  CHECK(ended.code == 4);
  CHECK_THAT(ended.err, ContainsSubstring("ffmpeg gave up on film.mp4: no such encoder"));
  const auto result = json(scratch / "c" / "compare.json");
  CHECK(result["stop_reason"] == "until");
  CHECK_THAT(result["warnings"][0].get<std::string>(), ContainsSubstring("no such encoder"));
  CHECK(fs::exists(scratch / "c" / "picture.png"));
  CHECK_FALSE(fs::exists(scratch / "film.mp4"));
}
