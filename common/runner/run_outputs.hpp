#pragma once

#include <string>

#include "common/runner/cadence.hpp"
#include "common/runner/film.hpp"
#include "common/runner/history.hpp"
#include "common/runner/options.hpp"
#include "common/runner/run_folder.hpp"
#include "common/runner/series.hpp"
#include "common/runner/vtk_files.hpp"

namespace clapotis {

/// Throws FileError when a file that the options name beside the run folder could not be written, or not be
/// made: nothing has been computed then.
void check_files(const Options& options);

/// What a headless run writes while it goes: series.csv, frames/, vtk/ and the video. It only watches.
class RunOutputs {
 public:
  /// `length` is how long the run will last at most [s].
  RunOutputs(const Stage& stage, const Options& options, Simulation& simulation, double length);

  /// Whether the state as it stands is to be written, and writes it.
  [[nodiscard]] bool due() const;
  void write_due();
  /// The state at the end, whatever ended the run; tells how much of the film is painted.
  void finish(const Film::Told& painted);
  /// picture.png, and the one that was asked for besides.
  void write_pictures() const;

  [[nodiscard]] const RunFolder& folder() const { return folder_; }
  [[nodiscard]] const History& history() const { return history_; }
  /// Why there is no video, when ffmpeg gave up: the run goes on without it.
  [[nodiscard]] const std::string& video_failure() const { return film_.failure(); }

 private:
  void record();
  void write_frame();
  void write_vtk();
  void shoot();
  [[nodiscard]] Picture picture(bool own_range) const;

  const Stage& stage_;
  const Options& options_;
  Simulation& simulation_;
  std::string colour_by_;
  RunFolder folder_;
  Cadence rows_, frames_, vtk_times_;
  Series series_;
  History history_;
  VtkFiles vtk_{folder_};
  WantedFilm film_;
  long last_recorded_ = -1, frame_count_ = 0;
};

}  // namespace clapotis
