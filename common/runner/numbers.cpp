#include "common/runner/numbers.hpp"

#include "common/simulation/errors.hpp"
#include "common/simulation/parameters.hpp"
#include "common/words.hpp"

namespace clapotis {

double reachable(double until, double dt) {
  if (until / dt > step_range.high)
    throw BadInput(say(words().too_many_steps, fmt::arg("until", to_text(until)),
                       fmt::arg("count", fmt::format("{:.3g}", until / dt)),
                       fmt::arg("dt", fmt::format("{:.4g}", dt)),
                       fmt::arg("most", to_text(step_range.high))));
  return until;
}

}  // namespace clapotis
