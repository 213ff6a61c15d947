#pragma once

#include <string>
#include <string_view>

#include "report/studies/study.hpp"

namespace clapotis::studies {

/// What a study came to, as a reader of a terminal wants it: a line for each finding, and the tables.
std::string text_of(const Conclusion& conclusion);

/// The name of an integrator as a reader wants it: explicit_euler is "explicit Euler".
std::string spoken(std::string_view integrator);

/// The conclusion for report.tex, which writes \val{STUDY/NAME} for a finding, its unit included, and
/// \rows{STUDY/NAME} for the rows of a table.
std::string latex_of(const std::string& study, const Conclusion& conclusion);

}  // namespace clapotis::studies
