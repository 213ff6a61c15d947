#include "common/kernels/wendland_c2.hpp"
#include "stage4_sph/models.hpp"

namespace clapotis::stage4 {

std::unique_ptr<Model> wendland_free(Parameters& p, const Period& period) {
  if (p.find("epsilon") != nullptr)
    return liquid_model<WendlandC2, TensileCorrection<WendlandC2>>(p, {}, period);
  return liquid_model<WendlandC2>(p, {}, period);
}

}  // namespace clapotis::stage4
