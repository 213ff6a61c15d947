#pragma once

#include <map>
#include <optional>
#include <string>
#include <vector>

#include "common/simulation/scene.hpp"

namespace CLI {
class App;
}

namespace clapotis {

/// The words of a command line, sorted but not yet understood.
struct Arguments {
  std::map<std::string, std::string, std::less<>>
      settings;                                    ///< scene, integrator, threads, seed, until, out, ...
  std::vector<std::string> set;                    ///< NAME=VALUE, in their order
  std::map<std::string, bool, std::less<>> flags;  ///< headless, json, quiet, ...
  std::vector<std::string> unknown;                ///< what no option takes
  std::string help;                                ///< what --help prints
  std::vector<std::string> options;                ///< all there are: "--headless", ...
};

/// Gives the headings of the help their names in the language in use.
void name_parts(CLI::App& app);

/// Throws BadInput for an option that lacks its value, or has one to no purpose; said here rather than by
/// CLI11, whose sentences differ from one version to the next, and are English.
void refuse_values(int argc, const char* const* argv, const std::vector<std::string>& takes_value,
                   const std::vector<std::string>& takes_none);

/// Throws BadInput for an option that none of these is, with the nearest of them.
void refuse_unknown(const CLI::App& app, const std::vector<std::string>& takes_value,
                    const std::vector<std::string>& takes_none);

/// Throws BadInput for an option that lacks its value.
Arguments sort_arguments(const Stage& stage, int argc, const char* const* argv);

}  // namespace clapotis
