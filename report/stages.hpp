#pragma once

#include <array>

#include "stage1_bouncing/scenes.hpp"
#include "stage2_cloud/scenes.hpp"
#include "stage3_grid/scenes.hpp"
#include "stage4_sph/scenes.hpp"
#include "stage5_extensions/scenes.hpp"

namespace clapotis {

/// The whole course, for what looks at more than one stage.
inline const std::array<Stage, 5>& all_stages() {
  static const std::array stages{stage1::stage(), stage2::stage(), stage3::stage(), stage4::stage(),
                                 stage5::stage()};
  return stages;
}

}  // namespace clapotis
