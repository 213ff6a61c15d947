#include "common/runner/video_file.hpp"

#include <fcntl.h>
#include <spawn.h>
#include <sys/socket.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <csignal>
#include <cstdio>
#include <cstdlib>
#include <string>
#include <vector>

#include "common/runner/atomic_file.hpp"
#include "common/simulation/errors.hpp"
#include "common/words.hpp"

namespace clapotis {
namespace {

/// The first ffmpeg on the PATH that may be run; empty where there is none.
std::filesystem::path find_encoder() {
  const char* path = std::getenv("PATH");
  std::string_view rest = path == nullptr ? "" : path;
  while (!rest.empty()) {
    const auto colon = std::min(rest.find(':'), rest.size());
    const auto candidate = std::filesystem::path(rest.substr(0, colon)) / "ffmpeg";
    rest.remove_prefix(std::min(colon + 1, rest.size()));
    std::error_code ignored;
    if (std::filesystem::is_regular_file(candidate, ignored) && access(candidate.c_str(), X_OK) == 0)
      return candidate;
  }
  return {};
}

std::filesystem::path encoder_for(const std::filesystem::path& file) {
  const auto encoder = find_encoder();
  if (encoder.empty()) throw FileError(say(words().no_encoder, fmt::arg("file", file.string())));
  return encoder;
}

/// "file:" keeps a name with a colon or a dash in front from being taken for something else.
std::vector<std::string> command(const std::filesystem::path& encoder, const std::filesystem::path& file,
                                 int width, int height) {
  return {encoder.string(),
          "-hide_banner",
          "-nostats",
          "-loglevel",
          "error",
          "-f",
          "rawvideo",
          "-pixel_format",
          "bgr0",
          "-video_size",
          std::to_string(width) + "x" + std::to_string(height),
          "-framerate",
          std::to_string(VideoFile::frames_per_second),
          "-i",
          "pipe:0",
          "-an",
          "-pix_fmt",
          "yuv420p",  // what every player reads
          "-movflags",
          "+faststart",
          "-f",
          "mp4",
          "-y",
          "file:" + part_of(file).string()};
}

/// Starts it with its input from `input` and its words to `said`; 0, or the reason why not.
int spawn(pid_t& process, std::vector<std::string> words, int input, int said) {
  std::vector<char*> argv;
  for (auto& word : words) argv.push_back(word.data());
  argv.push_back(nullptr);
  posix_spawn_file_actions_t files;
  posix_spawn_file_actions_init(&files);
  posix_spawn_file_actions_adddup2(&files, input, STDIN_FILENO);
  posix_spawn_file_actions_addopen(&files, STDOUT_FILENO, "/dev/null", O_WRONLY, 0);
  posix_spawn_file_actions_adddup2(&files, said, STDERR_FILENO);
  posix_spawnattr_t attributes;
  posix_spawnattr_init(&attributes);
  posix_spawnattr_setflags(&attributes, POSIX_SPAWN_SETPGROUP);
  posix_spawnattr_setpgroup(&attributes, 0);
  const int error = posix_spawn(&process, argv.front(), &files, &attributes, argv.data(), environ);
  posix_spawnattr_destroy(&attributes);
  posix_spawn_file_actions_destroy(&files);
  return error;
}

/// A file that is gone when it is closed.
int nameless_file() {
  auto name = (std::filesystem::temp_directory_path() / "clapotis-ffmpeg-XXXXXX").string();
  const int file = mkostemp(name.data(), O_CLOEXEC);
  if (file >= 0) unlink(name.c_str());
  return file;
}

std::string first_line(int file) {
  std::array<char, 512> text{};
  const auto count = pread(file, text.data(), text.size(), 0);
  const std::string_view all(text.data(), count > 0 ? static_cast<std::size_t>(count) : 0);
  return std::string(all.substr(0, all.find('\n')));
}

}  // namespace

void require_encoder(const std::filesystem::path& file) { static_cast<void>(encoder_for(file)); }

VideoFile::VideoFile(std::filesystem::path file, int width, int height) : file_(std::move(file)) {
  const auto encoder = encoder_for(file_);
  { const AtomicFile probe(file_); }  // where it cannot be written, our sentence says so
  // A socket rather than a pipe: a write to one that nobody reads any more is an error, not a signal.
  std::array<int, 2> ends{-1, -1};
  said_ = nameless_file();
  int error = said_ < 0 ? errno : 0;
  if (error == 0 && socketpair(AF_UNIX, SOCK_STREAM | SOCK_CLOEXEC, 0, ends.data()) != 0) error = errno;
  if (error == 0) {
    error = spawn(encoder_, command(encoder, file_, width, height), ends[1], said_);
    close(ends[1]);
    socket_ = ends[0];
  }
  if (error == 0) return;
  encoder_ = -1;
  if (socket_ >= 0) close(socket_);
  if (said_ >= 0) close(said_);
  refuse_file(words().cannot_write, file_, error);
}

VideoFile::~VideoFile() {
  try {
    finish();
  } catch (const FileError&) {  // who wants to know calls finish
  }
}

/// Its exit code, or 128 and the signal that ended it.
int VideoFile::end_encoder() {
  close(socket_);
  int status = 0;
  while (waitpid(encoder_, &status, 0) < 0 && errno == EINTR) {
  }
  encoder_ = -1;
  return WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status);
}

void VideoFile::fail(const std::string& otherwise) {
  auto reason = first_line(said_);
  close(said_);
  std::error_code ignored;
  std::filesystem::remove(part_of(file_), ignored);
  if (reason.empty()) reason = otherwise;
  throw FileError(say(words().encoder_failed, fmt::arg("file", file_.string()), fmt::arg("reason", reason)));
}

void VideoFile::add(std::span<const unsigned char> pixels) {
  while (!pixels.empty()) {
    const auto sent = send(socket_, pixels.data(), pixels.size(), MSG_NOSIGNAL);
    if (sent < 0 && errno == EINTR) continue;
    if (sent < 0) {
      fail(say(words().encoder_ended, fmt::arg("code", end_encoder())));
    }
    pixels = pixels.subspan(static_cast<std::size_t>(sent));
  }
  ++frames_;
}

void VideoFile::finish() {
  if (encoder_ < 0) return;
  if (const int code = end_encoder(); code != 0) fail(say(words().encoder_ended, fmt::arg("code", code)));
  if (std::rename(part_of(file_).c_str(), file_.c_str()) != 0) fail(std::generic_category().message(errno));
  close(said_);
}

}  // namespace clapotis
