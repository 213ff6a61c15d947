#include "common/runner/compare.hpp"

#include <array>

#include "stage1_bouncing/scenes.hpp"
#include "stage2_cloud/scenes.hpp"
#include "stage3_grid/scenes.hpp"
#include "stage4_sph/scenes.hpp"
#include "stage5_extensions/scenes.hpp"

int main(int argc, char** argv) {
  const std::array stages{clapotis::stage1::stage(), clapotis::stage2::stage(), clapotis::stage3::stage(),
                          clapotis::stage4::stage(), clapotis::stage5::stage()};
  return clapotis::run_compare(stages, argc, argv);
}
