#include "common/kernels/wendland_c2.hpp"
#include "stage4_sph/models.hpp"

namespace clapotis::stage4 {

std::unique_ptr<Model> wendland_in_tank(Parameters& p, DummyWalls walls) {
  return liquid_model<WendlandC2, Gravity, TankWalls>(p, std::move(walls), {});
}

}  // namespace clapotis::stage4
