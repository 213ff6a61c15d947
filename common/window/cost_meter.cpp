#include "common/window/cost_meter.hpp"

namespace clapotis {

void CostMeter::frame(Session& session, double elapsed, double painting) {
  const auto& work = session.work();
  elapsed_ += elapsed;
  painting_ += painting;
  stepping_ += work.seconds;
  simulated_ += work.simulated;
  steps_ += work.steps;
  late_ = late_ || !work.within_budget;
  ++frames_;
  auto& simulation = session.simulation();
  const bool anew = session.starts() != starts_;
  if (anew) rates_ = {};
  if (anew || (elapsed_ >= 0.5 && counted_at_ != simulation.steps())) {
    rates_.pairs.reset();
    if (simulation.model().has_pairs()) rates_.pairs = simulation.model().count_pairs(simulation.particles());
    counted_at_ = simulation.steps();
  }
  starts_ = session.starts();
  if (elapsed_ < 0.5) return;
  if (steps_ > 0) {
    rates_.step_milliseconds = 1e3 * stepping_ / static_cast<double>(steps_);
    rates_.possible_speed = simulated_ / stepping_;
  }
  rates_.frames_per_second = static_cast<double>(frames_) / elapsed_;
  rates_.frame_milliseconds = 1e3 * painting_ / static_cast<double>(frames_);
  rates_.speed = simulated_ / elapsed_;
  rates_.slower_than_asked = late_;
  elapsed_ = painting_ = stepping_ = simulated_ = 0;
  frames_ = steps_ = 0;
  late_ = false;
}

}  // namespace clapotis
