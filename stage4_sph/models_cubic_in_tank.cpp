#include "common/kernels/cubic_spline.hpp"
#include "stage4_sph/models.hpp"

namespace clapotis::stage4 {

std::unique_ptr<Model> cubic_in_tank(Parameters& p, DummyWalls walls) {
  return liquid_model<CubicSpline, Gravity, TankWalls>(p, std::move(walls), {});
}

}  // namespace clapotis::stage4
