#include "stage2_cloud/scenes.hpp"

#include "common/neighbours/all_pairs.hpp"

namespace clapotis::stage2 {

Stage stage() {
  return {.name = "stage2_cloud", .title = "Stage 2 - cloud", .scenes = cloud_scenes<AllPairs>()};
}

}  // namespace clapotis::stage2
