#include "stage4_sph/models.hpp"

namespace clapotis::stage4 {

std::unique_ptr<Model> tank_model(Parameters& p, DummyWalls walls) {
  return p.choice(kernel_choice) == "cubic_spline" ? cubic_in_tank(p, std::move(walls))
                                                   : wendland_in_tank(p, std::move(walls));
}

std::unique_ptr<Model> free_model(Parameters& p, const Period& period) {
  return p.choice(kernel_choice) == "cubic_spline" ? cubic_free(p, period) : wendland_free(p, period);
}

}  // namespace clapotis::stage4
