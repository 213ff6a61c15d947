#pragma once

#include <cstddef>
#include <filesystem>
#include <string>
#include <utility>

#include "tests/common/process.hpp"

namespace clapotis::testing {

/// A folder with an ffmpeg that runs `script`, to be the whole PATH; its last word is in $out. So videos are
/// tested where none is installed.
inline Start with_encoder(const Scratch& scratch, const std::string& script) {
  std::filesystem::create_directory(scratch / "bin");
  const auto encoder = scratch / "bin" / "ffmpeg";
  write(encoder,
        "#!/bin/sh\necho \"$@\" > arguments\nfor out; do :; done\nout=${out#file:}\n" + script + "\n");
  std::filesystem::permissions(encoder, std::filesystem::perms::owner_all);
  return {.environment = {{"PATH", (scratch / "bin").string()}}};
}
inline const std::string keeps_all = "exec /bin/cat > \"$out\"";

/// A rectangle of a frame, from its upper left corner [pixel].
struct Part {
  std::size_t x, y, width, height;
};
inline constexpr Part legend{800, 0, 470, 60};  ///< the bar and its numbers, right of the title

/// The film that such an ffmpeg keeps: 1280 x 720, 4 bytes to a pixel, one frame after the other.
class Frames {
 public:
  explicit Frames(std::string bytes) : bytes_(std::move(bytes)) {}
  [[nodiscard]] std::size_t size() const { return bytes_.size() / bytes_per_frame; }
  [[nodiscard]] bool whole() const { return bytes_.size() % bytes_per_frame == 0; }
  [[nodiscard]] std::string frame(std::size_t k) const {
    return bytes_.substr(k * bytes_per_frame, bytes_per_frame);
  }
  [[nodiscard]] std::string part(std::size_t k, const Part& part) const {
    std::string all;
    for (std::size_t y = part.y; y < part.y + part.height; ++y)
      all += bytes_.substr(k * bytes_per_frame + 4 * (1280 * y + part.x), 4 * part.width);
    return all;
  }

 private:
  static constexpr std::size_t bytes_per_frame = 1280 * 720 * 4;
  std::string bytes_;
};

}  // namespace clapotis::testing
