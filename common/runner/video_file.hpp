#pragma once

#include <sys/types.h>

#include <filesystem>
#include <span>
#include <string>

namespace clapotis {

/// Throws FileError when there is no ffmpeg on the PATH, naming the video it was wanted for: asked before a
/// long run, not after it.
void require_encoder(const std::filesystem::path& file);

/// A video that ffmpeg encodes as the frames come, in a process of its own: no shell, and Ctrl-C in the
/// terminal does not reach it. It grows as `file.part`; should this program be killed, ffmpeg finishes that.
class VideoFile {
 public:
  static constexpr int frames_per_second = 30;

  /// Throws FileError when there is no ffmpeg, or when it cannot be started.
  VideoFile(std::filesystem::path file, int width, int height);
  ~VideoFile();  ///< finishes; a failure is not said
  VideoFile(const VideoFile&) = delete;
  VideoFile& operator=(const VideoFile&) = delete;

  /// One more frame, rows of pixels of 4 bytes: blue, green, red, nothing. Throws FileError, with what ffmpeg
  /// said, when it is gone.
  void add(std::span<const unsigned char> pixels);
  /// Waits until ffmpeg is done; then the video is there under its name. Throws FileError.
  void finish();

  [[nodiscard]] long frames() const { return frames_; }
  [[nodiscard]] const std::filesystem::path& file() const { return file_; }

 private:
  [[nodiscard]] int end_encoder();
  /// Why is what ffmpeg said, or else `otherwise`.
  [[noreturn]] void fail(const std::string& otherwise);

  std::filesystem::path file_;
  int socket_ = -1;  ///< to ffmpeg's standard input
  int said_ = -1;    ///< a file without a name with what ffmpeg says
  pid_t encoder_ = -1;
  long frames_ = 0;
};

}  // namespace clapotis
