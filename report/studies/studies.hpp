#pragma once

#include "report/studies/study.hpp"

namespace clapotis::studies {

Study orders();
Study handout_errata();
Study work_precision_sph();
Study dam_break();

}  // namespace clapotis::studies
