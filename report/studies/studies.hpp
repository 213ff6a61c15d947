#pragma once

#include "report/studies/study.hpp"

namespace clapotis::studies {

Study orders();

}  // namespace clapotis::studies
