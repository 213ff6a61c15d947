#pragma once

#include "report/studies/study.hpp"

namespace clapotis::studies {

Study orders();
Study work_precision_bounce();
Study work_precision_spring();
Study list_or_grid();
Study handout_errata();
Study stability_map();
Study work_precision_sph();
Study dam_break();
Study sloshing();
Study standing_wave();
Study capillarity();
Study honey();
Study jet();
Study pay_for_what_you_use();
Study scaling();
Study long_run();
Study hard_cases();
Study window_times();

}  // namespace clapotis::studies
