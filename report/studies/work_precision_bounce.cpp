#include "report/studies/studies.hpp"
#include "report/studies/work_precision.hpp"

namespace clapotis::studies {

/// The ball of stage 1 falls from 1 m through air and has met the floor three times at 1.6 s. Impacts are
/// found inside the step; one more lane shows what remains of the best of the fixed schemes where they are
/// not.
Study work_precision_bounce() {
  return work_precision(
      {.name = "work_precision_bounce",
       .question = "Which integrator follows a bouncing ball at the least cost, for a wanted error?",
       .unit = "m",
       .until = 1.6,
       .instants = 16,
       .lanes = {{.name = "located",
                  .scene = "stage1/drop",
                  .starts = {{{"impacts", "located"}}},
                  .schemes = {"explicit_euler", "symplectic_euler", "velocity_verlet", "rk2", "rk4",
                              "bogacki_shampine"}},
                 {.name = "clamp",
                  .scene = "stage1/drop",
                  .starts = {{{"impacts", "clamp"}}},
                  .schemes = {"rk4"}}}});
}

}  // namespace clapotis::studies
