#pragma once

#include <string>
#include <utility>
#include <vector>

#include "report/studies/study.hpp"

namespace clapotis::studies {

using Values = std::vector<std::pair<std::string, std::string>>;

/// Schemes that follow the same motion, of which the closed form is known.
struct Lane {
  std::string name;  ///< what it differs in from the others: a cell of the column `case`
  std::string scene;
  std::vector<Values> starts;  ///< one for each run that the error is taken over
  std::vector<std::string> schemes;
};

/// Error against cost, from coarse steps to fine ones; bogacki_shampine from loose tolerances to tight ones.
struct WorkPrecision {
  std::string name, question, unit;  ///< the unit is that of the error
  double until;                      ///< [s]
  int instants;                      ///< of the run, evenly, at which the error is taken; no step is longer
  std::vector<Lane> lanes;
};

/// The error is the root mean square over all instants of all runs; costs are means over the runs.
Study work_precision(const WorkPrecision& race);

}  // namespace clapotis::studies
