#pragma once

#include "stage2_cloud/cloud.hpp"

namespace clapotis::stage2 {

/// cloud, pair and stack, neighbours by trying all pairs.
Stage stage();

}  // namespace clapotis::stage2
