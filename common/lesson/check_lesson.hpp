#pragma once

#include <span>

#include "common/lesson/findings.hpp"
#include "common/simulation/scene.hpp"

namespace clapotis {

/// Runs what the exercise tells to run, without window or files, and measures what its checks ask. Throws
/// BadInput or LessonError for a command that cannot be carried out.
Findings carry_out(const Exercise& exercise, std::span<const Stage> stages);

}  // namespace clapotis
