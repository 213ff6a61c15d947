#pragma once

#include "report/studies/study.hpp"

namespace clapotis::studies {

Study orders();
Study sloshing();
Study standing_wave();
Study capillarity();
Study honey();
Study jet();

}  // namespace clapotis::studies
