#pragma once

#include <functional>
#include <string>

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

HardCase one_point();
HardCase exact_corner();
HardCase huge_speed();
HardCase large_step();
HardCase bad_input();
HardCase crowded_cell();
HardCase million_steps();
HardCase extreme_masses();
HardCase window();
HardCase any_threads();

}  // namespace clapotis::studies
