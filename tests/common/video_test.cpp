#include <csignal>
#include <filesystem>
#include <nlohmann/json.hpp>
#include <thread>

#include "tests/common/encoder.hpp"
#include "tests/common/programs.hpp"

// --video, with an ffmpeg of our own that keeps what it is given: none needs to be installed.

using namespace clapotis::testing;
using Catch::Matchers::ContainsSubstring;
namespace fs = std::filesystem;

TEST_CASE("a video shows a run at equal steps of its time, 30 frames of 1280 x 720 a second", "[video]") {
  const Scratch scratch;
  const auto start = with_encoder(scratch, keeps_all);
  const auto ended = run(
      scratch, stage1,
      {"bounce", "--headless", "--until", "1", "--video", "film.mp4", "--video-every", "0.1", "--out", "r"},
      start);
  require_done(ended);
  const Frames film(read(scratch / "film.mp4"));
  REQUIRE(film.whole());
  REQUIRE(film.size() == 11);  // t = 0, 0.1, ... 1
  CHECK_THAT(read(scratch / "arguments"),
             ContainsSubstring("-video_size 1280x720") && ContainsSubstring("-framerate 30"));
  CHECK(film.frame(0) != film.frame(10));
  CHECK_FALSE(fs::exists(scratch / "film.mp4.part"));
  for (std::size_t k = 0; k < 11; ++k)  // the paper in a corner is painted, and nearly white
    REQUIRE(static_cast<unsigned char>(film.part(k, {3, 0, 1, 1})[0]) > 200);
}

TEST_CASE("a frame is shown as long as its step lasts: a run of few steps has a film of constant pace",
          "[video]") {
  const Scratch scratch;
  const auto ended = run(scratch, stage1,
                         {"drop", "--headless", "--until", "0.4", "--set", "dt=0.1", "--video", "film.mp4",
                          "--video-every", "0.05", "--out", "r"},
                         with_encoder(scratch, keeps_all));
  require_done(ended);
  const Frames film(read(scratch / "film.mp4"));
  REQUIRE(film.size() == 9);  // t = 0, then two frames for each of four steps
  CHECK(film.frame(1) == film.frame(2));
  CHECK(film.frame(2) != film.frame(3));
}

TEST_CASE("a film of a run that nobody gave a pace lasts five seconds at least", "[video]") {
  const Scratch scratch;
  const auto ended =
      run(scratch, stage1, {"drop", "--headless", "--until", "0.5", "--video", "film.mp4", "--out", "r"},
          with_encoder(scratch, keeps_all));
  require_done(ended);
  CHECK(Frames(read(scratch / "film.mp4")).size() == 151);
}

TEST_CASE("colours mean the same from the first frame of a video to the last", "[video]") {
  const Scratch scratch;
  // the discs fall from rest: their speed, and the range of a picture of its own, grow from 0
  const auto ended = run(scratch, stage2,
                         {"cloud", "--headless", "--until", "0.6", "--set", "particles=40", "--video",
                          "film.mp4", "--video-every", "0.2", "--out", "r"},
                         with_encoder(scratch, keeps_all));
  require_done(ended);
  const Frames film(read(scratch / "film.mp4"));
  REQUIRE(film.size() == 4);
  for (std::size_t k = 1; k < 4; ++k) CHECK(film.part(k, legend) == film.part(0, legend));
}

TEST_CASE("without an ffmpeg a video is refused with 4 and the remedy before anything is computed",
          "[video]") {
  const Scratch scratch;
  fs::create_directory(scratch / "empty");
  const auto ended = run(scratch, stage4, {"--headless", "--video", "film.mp4", "--out", "r"},
                         {.environment = {{"PATH", (scratch / "empty").string()}}});
  CHECK(ended.code == 4);
  CHECK_THAT(ended.err,
             ContainsSubstring("no ffmpeg") && ContainsSubstring("film.mp4") && ContainsSubstring("install"));
  CHECK_FALSE(fs::exists(scratch / "r"));
}

TEST_CASE("a video is named .mp4 and goes to a folder that exists, and its pace needs a video", "[video]") {
  const Scratch scratch;
  const auto start = with_encoder(scratch, keeps_all);
  const auto refused = [&](std::vector<std::string> arguments, int code, const std::string& sentence) {
    arguments.emplace_back("--headless");
    const auto ended = run(scratch, stage1, arguments, start);
    CHECK(ended.code == code);
    CHECK_THAT(ended.err, ContainsSubstring(sentence));
  };
  refused({"--video", "film.avi"}, 2, "film.avi: the name must end in .mp4");
  refused({"--video", "no/folder/film.mp4"}, 4, "cannot write no/folder/film.mp4");
  refused({"--video-every", "0.1"}, 2, "--video-every has no meaning without --video");
  CHECK(run(scratch, stage1, {"--video", "film.mp4"}, start).code == 2);
}

TEST_CASE("when ffmpeg gives up, the run goes on, leaves all else, and ends with 4 and what ffmpeg said",
          "[video]") {
  const Scratch scratch;
  for (const std::string script :
       {"echo 'no such encoder' >&2; exit 3",
        "/bin/dd bs=1000000 count=1 of=/dev/null 2>/dev/null; echo 'disk full' >&2; "
        "exit 1"}) {
    const auto ended =
        run(scratch, stage1,
            {"drop", "--headless", "--until", "0.5", "--video", "film.mp4", "--force", "--out", "r"},
            with_encoder(scratch, script));
    CHECK(ended.code == 4);
    CHECK_THAT(ended.err, ContainsSubstring("ffmpeg gave up on film.mp4") &&
                              (ContainsSubstring("no such encoder") || ContainsSubstring("disk full")));
    const auto json = nlohmann::json::parse(read(scratch / "r" / "run.json"));
    CHECK(json["stop_reason"] == "until");
    CHECK(json["warnings"].size() == 1);
    CHECK(fs::exists(scratch / "r" / "final.csv"));
    CHECK_FALSE(fs::exists(scratch / "film.mp4"));
    CHECK_FALSE(fs::exists(scratch / "film.mp4.part"));
  }
}

TEST_CASE("a run that is interrupted leaves the film so far", "[video]") {
  const Scratch scratch;
  Process process(scratch, stage1,
                  {"bounce", "--headless", "--until", "1e9", "--video", "film.mp4", "--video-every", "1e6",
                   "--every", "1e6", "--out", "r"},
                  with_encoder(scratch, keeps_all));
  for (int k = 0; k < 600 && !fs::exists(scratch / "r" / "run.json"); ++k)
    std::this_thread::sleep_for(std::chrono::milliseconds(20));
  process.send(SIGINT);
  CHECK(process.wait().code == 130);
  const Frames film(read(scratch / "film.mp4"));
  CHECK(film.size() >= 1);
  CHECK(film.whole());
}
