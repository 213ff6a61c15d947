#pragma once

#include <filesystem>
#include <map>
#include <string>

#include "common/simulation/parameters.hpp"

namespace clapotis {

/// What a file of --config gives: a hand-written one, or the run.json of an earlier run, which then is the
/// same run again. Values are as a user would type them; they are checked where the command line's are.
struct ConfigFile {
  std::map<std::string, std::string, std::less<>>
      settings;  ///< stage, scene, integrator, threads, until, ...
  Overrides parameters;
  bool of_resumed_run = false;  ///< which began at a saved state
};

/// Throws FileError when it cannot be read, and BadInput, naming the file and the line or key, when it is not
/// JSON (comments are allowed), has an unknown key (naming the nearest one) or a value of the wrong kind.
ConfigFile read_config(const std::filesystem::path& file);

}  // namespace clapotis
