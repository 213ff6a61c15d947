#include "stage3_grid/scenes.hpp"

#include "common/neighbours/cell_grid.hpp"
#include "stage2_cloud/cloud.hpp"

namespace clapotis::stage3 {

Stage stage() {
  return {.name = "stage3_grid", .title = "Stage 3 - grid", .scenes = stage2::cloud_scenes<CellGrid>()};
}

}  // namespace clapotis::stage3
