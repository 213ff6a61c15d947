#include "common/kernels/cubic_spline.hpp"
#include "stage4_sph/models.hpp"

namespace clapotis::stage4 {

std::unique_ptr<Model> cubic_free(Parameters& p, const Period& period) {
  if (p.find("epsilon") != nullptr)
    return liquid_model<CubicSpline, TensileCorrection<CubicSpline>>(p, {}, period);
  return liquid_model<CubicSpline>(p, {}, period);
}

}  // namespace clapotis::stage4
