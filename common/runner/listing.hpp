#pragma once

#include <string>

#include "common/runner/options.hpp"

namespace clapotis {

/// What --list prints of `kind` (scenes, parameters, integrators); as JSON for a program. Of a scene that the
/// user chose, the parameters are listed; of all scenes otherwise. Throws BadInput for another kind.
std::string listing(const Stage& stage, const std::string& kind, const Options& options);

/// What --print-config prints: each value, its unit, and where it comes from. As JSON it can be given to
/// --config.
std::string configuration(const Stage& stage, const Options& options);

}  // namespace clapotis
