#pragma once

#include <filesystem>
#include <string>

#include "common/runner/manifest.hpp"

namespace clapotis {

/// What a headless run tells its user on some lines.
std::string summary(const std::filesystem::path& folder, Simulation& simulation, const RunResult& result);

}  // namespace clapotis
