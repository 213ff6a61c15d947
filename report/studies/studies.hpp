#pragma once

#include "report/studies/study.hpp"

namespace clapotis::studies {

Study orders();
Study work_precision_bounce();
Study work_precision_spring();
Study stability_map();
Study long_run();

}  // namespace clapotis::studies
