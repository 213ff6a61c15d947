#pragma once

#include <functional>
#include <string>
#include <vector>

#include "report/studies/study.hpp"

namespace clapotis::studies {

/// What came of a hard case. Text of a table: no commas.
struct Outcome {
  std::string happened;
  bool passed;
};

/// Something that breaks solvers.
struct HardCase {
  std::string name, tried, criterion;
  std::function<Outcome(Effort)> run;  ///< none where a window is needed, and a test holds it
};

std::vector<HardCase> hard_cases_of_particles();
std::vector<HardCase> hard_cases_of_runs();

}  // namespace clapotis::studies
