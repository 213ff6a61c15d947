#include "stage3_grid/scenes.hpp"

#include "common/neighbours/cell_grid.hpp"
#include "stage2_cloud/scenes.hpp"

namespace clapotis::stage3 {

Stage stage() {
  Stage grid{.name = "stage3_grid", .title = "Stage 3 - grid", .scenes = stage2::cloud_scenes<CellGrid>()};
  const Stage list = stage2::stage();
  for (auto& scene : grid.scenes)
    scene.rival = Rival{.what = "neighbour_search",
                        .own = "grid",
                        .other = "list",
                        .stage = list.name,
                        .build = list.scene(scene.name).build};
  return grid;
}

}  // namespace clapotis::stage3
