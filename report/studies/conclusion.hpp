#pragma once

#include <string>

#include "report/studies/study.hpp"

namespace clapotis::studies {

/// What a study came to, as a reader of a terminal wants it: a line for each finding, and the tables.
std::string text_of(const Conclusion& conclusion);

/// The same for report.tex, which writes \val{STUDY/NAME} for a finding, its unit included, and
/// \rows{STUDY/NAME} for the rows of a table.
std::string latex_of(const std::string& study, const Conclusion& conclusion);

}  // namespace clapotis::studies
