#include "common/simulation/system.hpp"

#include "common/simulation/model.hpp"

namespace clapotis {

int System::threads() const { return model.threads; }

void System::evaluate(double t) {
  model.evaluate(*this, t);
  if (bear) bear(*this);
  ++force_evaluations;
}

}  // namespace clapotis
