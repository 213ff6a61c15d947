#pragma once

#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "common/runner/ink.hpp"
#include "common/simulation/scene.hpp"

namespace clapotis {

struct SavedState;

/// A value and who gave it.
template <class T>
struct Given {
  T value;
  Origin origin = Origin::law;
};

/// What a run is to do: command line over environment over file; what nobody gave is the scene's or the
/// laws'.
struct Options {
  Given<std::string> scene;  ///< a scene that exists
  Overrides parameters;
  Given<std::string> integrator{std::string(default_integrator)};
  Given<int> threads{1};

  std::optional<Given<double>> until;  ///< simulated time to stop at [s]
  std::optional<Given<long>> steps;    ///< steps to stop after

  bool headless = false, quiet = false, json = false, paused = false, force = false;
  double scale = 0;                              ///< of the window's letters; 0: by the screen
  std::optional<std::filesystem::path> out;      ///< the run folder
  std::optional<std::filesystem::path> picture;  ///< an additional one: .png, .svg, .pdf
  std::optional<double> every, frames, vtk;      ///< intervals of series.csv, of frames/ and of vtk/ [s]
  std::optional<std::filesystem::path> video;    ///< .mp4
  std::optional<double> video_every;             ///< simulated time between two of its frames [s]
  std::optional<std::filesystem::path> save;     ///< where the state goes at the end
  std::shared_ptr<const SavedState> resume;      ///< what to go on from

  /// NAME and VALUE: what the right side has in a window of two.
  std::optional<std::pair<std::string, std::string>> beside;
  ink::Theme theme = ink::Theme::light;
  std::optional<std::string> colour_by;  ///< what pictures show first; the scene's choice otherwise

  std::vector<std::string> warnings;  ///< whole sentences
};

/// A command line either asks for a text (help, version, a list) or for a run.
struct Command {
  std::optional<std::string> answer;
  Options options;
};

/// Reads the command line, the environment's CLAPOTIS_* and the file of --config. Throws BadInput for
/// whatever cannot be used, naming the nearest option, scene, integrator or key; parameters are checked by
/// the scene.
Command read_command_line(const Stage& stage, int argc, const char* const* argv);

/// Throws BadInput for a video whose name does not end in .mp4, and for the time between its frames where
/// there is none.
void check_video(const std::optional<std::filesystem::path>& video, const std::optional<double>& every);

/// Until when a run goes for which nobody said it [s].
inline constexpr double default_until = 5;

/// The name and number of this software.
std::string version();

}  // namespace clapotis
