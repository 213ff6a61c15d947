#pragma once

#include <filesystem>
#include <optional>
#include <span>
#include <string>

#include "common/runner/options.hpp"

namespace clapotis {

/// One side as it is asked for.
struct SideOptions {
  std::string text;
  const Stage* stage;
  const Scene* scene;
  Overrides parameters;
  std::string integrator{default_integrator};
  int threads = 1;
};

struct CompareOptions {
  std::optional<std::string> answer;  ///< what --help prints; nothing else is done then
  std::optional<SideOptions> left, right;
  std::optional<double> until, every;
  std::optional<long> steps;
  std::optional<std::filesystem::path> out;
  std::optional<std::filesystem::path> video;  ///< .mp4
  std::optional<double> video_every;           ///< simulated time between two of its frames [s]
  bool force = false, json = false, quiet = false;
};

/// Reads STAGE/SCENE[:NAME=VALUE,...]; a stage may be shortened to where it is the only one. Throws BadInput.
SideOptions read_side(std::span<const Stage> stages, const std::string& text);

CompareOptions read_compare_options(std::span<const Stage> stages, int argc, const char* const* argv);

}  // namespace clapotis
