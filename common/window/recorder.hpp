#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "common/runner/film.hpp"
#include "common/window/session.hpp"

namespace clapotis {

/// STAGE-SCENE-tTIMEs.EXTENSION in the current folder, with a number where that exists.
std::filesystem::path free_name(const Session& session, std::string_view extension);

/// What the window keeps of a session when it is asked to: states to come back to, and a video.
class Recorder {
 public:
  /// Saves the session's state in a new file and returns its name. Throws FileError.
  std::string save(Session& session);
  /// Back to the state that was saved last, of whatever scene. Throws FileError, and BadInput when none was.
  void restore(Session& session) const;
  [[nodiscard]] const std::filesystem::path& saved() const { return saved_; }

  /// Begins a video. It shows simulated time at the speed that is set, however slow the computing. Throws
  /// FileError, as where there is no ffmpeg.
  void begin(const Session& session);
  [[nodiscard]] bool recording() const { return film_.has_value(); }
  /// Adds what the window shows when a frame of it is due. Throws FileError when the video had to be given
  /// up.
  void shoot(const Session& session, const Picture& picture, const std::optional<Beside>& beside,
             const std::vector<Plot>& plots);
  /// Ends the video and returns its name. Throws FileError.
  std::string end();
  [[nodiscard]] double seconds() const { return film_ ? film_->seconds() : 0; }  ///< of the video so far

 private:
  std::filesystem::path saved_;
  std::optional<Film> film_;
  long leaps_ = 0;  ///< of the session, when it was last shot
};

}  // namespace clapotis
