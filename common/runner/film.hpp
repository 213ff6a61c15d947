#pragma once

#include <algorithm>
#include <filesystem>
#include <functional>
#include <limits>
#include <optional>
#include <string>
#include <vector>

#include "common/runner/cairo_canvas.hpp"
#include "common/runner/colour_range.hpp"
#include "common/runner/sheet.hpp"
#include "common/runner/video_file.hpp"

namespace clapotis {

/// A run as a video of 1280 x 720: the sheet of picture.png, at equal steps of simulated time.
class Film {
 public:
  /// What becomes of the range of colours of each picture. `one_for_all` takes one that serves the whole
  /// film: pictures wait until the end, or until there are many of them, before they are painted.
  enum class Colours { as_given, one_for_all };

  /// `interval` is the simulated time between two frames, from `start` on [s]. Throws FileError as VideoFile
  /// does.
  Film(std::filesystem::path file, double start, double interval, Colours colours);

  /// Whether the state at `time` is to be in it; `dt` is the step that goes on from it.
  [[nodiscard]] bool due(double time, double dt) const { return time + rounding * dt >= next_; }
  [[nodiscard]] double next() const { return next_; }  ///< the time of the next frame [s]
  /// Shows it, for as many frames as have become due. Throws FileError when ffmpeg is gone.
  void add(Picture picture, std::vector<Plot> plots, double time, double dt,
           std::optional<Beside> beside = {});
  /// Goes on from another instant, or at another pace: a run that starts anew, a speed that changed.
  void go_on_from(double time) { next_ = time; }
  void pace(double interval) { interval_ = interval; }
  using Told = std::function<void(double share)>;  ///< of what is painted so far, 0 to 1
  /// Paints what waits, which may take a while, and ends the video. Throws FileError.
  void finish(const Told& painted = [](double) {});

  [[nodiscard]] const std::filesystem::path& file() const { return video_.file(); }
  [[nodiscard]] double seconds() const;  ///< of the film so far

 private:
  struct Shot {
    Picture picture;
    std::vector<Plot> plots;
    long frames;
    std::optional<Beside> beside;
  };
  void paint(const Shot& shot);
  void paint_waiting(const Told& painted);

  static constexpr double rounding = 1e-6;  ///< share of a step by which an instant may be missed
  VideoFile video_;
  double next_, interval_;
  bool waits_;
  std::vector<Shot> waiting_;
  std::size_t waiting_bytes_ = 0;
  ColourRange range_;
  long frames_ = 0;
};

/// The film of a run, where one is wanted, in one range of colours. When ffmpeg gives up, why is kept, and
/// the run goes on without it.
class WantedFilm {
 public:
  /// Throws FileError as Film does.
  void begin(std::filesystem::path file, double start, double interval) {
    film_.emplace(std::move(file), start, interval, Film::Colours::one_for_all);
  }
  /// As of Film; without one, nothing is due ever.
  [[nodiscard]] bool due(double time, double dt) const { return film_ && film_->due(time, dt); }
  [[nodiscard]] double next() const {
    return film_ ? film_->next() : std::numeric_limits<double>::infinity();
  }
  void add(Picture picture, std::vector<Plot> plots, double time, double dt,
           std::optional<Beside> beside = {});
  void finish(const Film::Told& painted);
  /// Why there is none although it was wanted; empty otherwise.
  [[nodiscard]] const std::string& failure() const { return failure_; }

 private:
  void attempt(const std::function<void(Film&)>& act);

  std::optional<Film> film_;
  std::string failure_;
};

/// Simulated time between two frames when nobody says [s]: in real time, but a film lasts from 5 to 60
/// seconds.
inline double usual_film_interval(double length) {
  constexpr double shortest = 5, longest = 60;
  return length / (VideoFile::frames_per_second * std::clamp(length, shortest, longest));
}

}  // namespace clapotis
