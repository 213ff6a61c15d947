#pragma once

#include <span>

#include "report/studies/study.hpp"

namespace clapotis::studies {

/// The program `study`: runs the studies that its command line names, and goes on where an earlier run of one
/// was stopped. Returns the exit code.
int run_studies(std::span<const Study> studies, int argc, const char* const* argv);

}  // namespace clapotis::studies
