// What the window keeps when it is asked to: states and videos, with real key events. ffmpeg is one of our
// own that keeps what it is given.

#include <filesystem>
#include <fstream>
#include <string>

#include "tests/catch.hpp"
#include "tests/window/desk.hpp"

using clapotis::testing::Desk;
namespace fs = std::filesystem;

namespace {

const std::string stage1_program = STAGE1_PROGRAM, stage3_program = STAGE3_PROGRAM;

constexpr std::uintmax_t bytes_per_frame = 1280 * 720 * 4;

/// A PATH for the program under test, with an ffmpeg that keeps its input under the name of the video.
std::map<std::string, std::string> with_encoder(const Desk& desk) {
  const auto folder = desk.folder() / "bin";
  fs::create_directories(folder);
  std::ofstream(folder / "ffmpeg") << "#!/bin/sh\nfor out; do :; done\nexec /bin/cat > \"${out#file:}\"\n";
  fs::permissions(folder / "ffmpeg", fs::perms::owner_all);
  return {{"PATH", folder.string()}};
}

/// The only video in the desk's folder.
fs::path video_of(const Desk& desk) {
  for (const auto& entry : fs::directory_iterator(desk.folder()))
    if (entry.path().extension() == ".mp4") return entry.path();
  return {};
}

}  // namespace

TEST_CASE("F5 saves the state and says where, F9 comes back to it bit for bit, also from another scene",
          "[window]") {
  Desk desk("state");
  desk.start({stage3_program, "--paused", "--set", "particles=60"});
  desk.await("step 0 ");
  desk.key("F9");
  desk.await("notice There is nothing to come back to yet");
  desk.key("shift+n");
  desk.await("step 10 ");
  desk.key("F5");
  const auto notice = desk.await("notice Saved ");
  const auto file = notice.substr(0, notice.find(';'));
  CHECK(file.starts_with("stage3_grid-cloud-t"));
  CHECK(fs::file_size(desk.folder() / file) > 1000);
  desk.key("n");
  const auto next = desk.await("step 11 ");
  desk.key("F9");
  desk.await("notice Back to " + file);
  desk.await("step 10 ");
  desk.key("n");
  CHECK(desk.await("step 11 ") == next);  // time and energy to the last digit
  desk.key("Page_Down");
  desk.await("started 3");
  desk.key("F9");
  desk.await("scene cloud");
  desk.await("step 10 ");
  desk.key("n");
  CHECK(desk.await("step 11 ") == next);
}

TEST_CASE("F10 begins a video, whose mark is seen, and ends it", "[window]") {
  Desk desk("video");
  desk.start({stage1_program, "drop", "--set", "dt=0.01", "--paused"}, with_encoder(desk));
  desk.await("paused");
  desk.key("F10");
  desk.await("recording on");
  desk.picture("recording");
  desk.key("shift+n");
  desk.await("step 10 ");
  desk.key("F10");
  desk.await("recording off");
  const auto file = desk.folder() / desk.await("notice Saved ");
  const auto size = fs::file_size(file);
  CHECK(size >= 2 * bytes_per_frame);  // at rest, and after the steps
  CHECK(size % bytes_per_frame == 0);
}

TEST_CASE("a video that is being made when the window is closed is whole", "[window]") {
  Desk desk("video-closed");
  desk.start({stage1_program, "bounce"}, with_encoder(desk));
  desk.await("running");
  desk.key("F10");
  desk.await("recording on");
  desk.await("time ");
  desk.key("Escape");
  desk.await("closed");
  CHECK(desk.await_exit() == 0);
  const auto size = fs::file_size(video_of(desk));
  CHECK(size >= bytes_per_frame);
  CHECK(size % bytes_per_frame == 0);
}

TEST_CASE("without an ffmpeg the window says so when a video is asked for, and goes on", "[window]") {
  Desk desk("no-ffmpeg");
  desk.start({stage1_program, "--paused"}, {{"PATH", desk.folder().string()}});
  desk.await("paused");
  desk.key("F10");
  CHECK(desk.await("notice there is no ffmpeg").find("install") != std::string::npos);
  CHECK_FALSE(desk.seen("recording on"));
  desk.key("n");
  desk.await("step 1 ");
}

TEST_CASE("the buttons of the row of records do what their keys do", "[window]") {
  Desk desk("record-row");
  desk.start({stage3_program, "--paused"}, with_encoder(desk));
  desk.await("step 0 ");
  desk.click_control("save");
  desk.await("notice Saved ");
  desk.key("n");
  desk.await("step 1 ");
  desk.click_control("restore");
  desk.await("step 0 ");
  desk.click_control("video");
  desk.await("recording on");
  desk.picture("row");
  desk.click_control("video");
  desk.await("recording off");
  desk.click_control("picture");
  desk.await("notice Saved stage3_grid-cloud-t0.000s.png");
}

TEST_CASE("the particles as they stand are written as a table and as a grid", "[window]") {
  Desk desk("table_and_grid");
  desk.start({STAGE2_PROGRAM, "--paused"});
  desk.await("step 0 ");
  for (const std::string name : {"table", "grid_file"}) {
    desk.click_control(name);
    const auto file = desk.await("notice Saved ");
    CHECK(std::filesystem::file_size(desk.folder() / file) > 1000);
  }
}
