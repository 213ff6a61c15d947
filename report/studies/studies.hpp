#pragma once

#include "report/studies/study.hpp"

namespace clapotis::studies {

Study orders();
Study list_or_grid();
Study pay_for_what_you_use();
Study scaling();
Study hard_cases();

}  // namespace clapotis::studies
