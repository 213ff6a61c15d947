#include "common/simulation/time_step.hpp"

#include <algorithm>
#include <cmath>

#include "common/simulation/errors.hpp"
#include "common/words.hpp"

namespace clapotis {

double falling_sound_speed(const Parameters& p) {
  const auto value = [&](std::string_view name) {
    const auto* parameter = p.find(name);
    return parameter != nullptr ? parameter->value : 0;
  };
  const double vx = value("vx0"), vy = value("vy0");
  const double fall = std::max(value("height"), value("y0"));
  return 10 * std::sqrt(vx * vx + vy * vy + 2 * value("gravity") * fall);
}

StepLimit acoustic_limit(double radius, double sound_speed, double cfl) {
  return {
      .name = "acoustic", .formula = "h/c", .limit = radius / sound_speed, .share = cfl, .stability = false};
}

const StepLimit& binding(const std::vector<StepLimit>& limits) {
  return *std::min_element(limits.begin(), limits.end(), [](const auto& a, const auto& b) {
    return a.share * a.limit < b.share * b.limit;
  });
}

const StepLimit* broken_limit(double dt, const std::vector<StepLimit>& limits) {
  const StepLimit* broken = nullptr;
  for (const auto& limit : limits)
    if (limit.stability && dt > limit.limit * (1 + 1e-9) &&
        (broken == nullptr || limit.limit < broken->limit))
      broken = &limit;
  return broken;
}

double choose_dt(double wanted, const std::vector<StepLimit>& limits) {
  if (!std::isnan(wanted)) return wanted;
  const auto& least = binding(limits);
  const double dt = least.share * least.limit;
  if (std::isinf(dt)) throw BadInput(std::string(words().no_time_step));
  if (!(dt > 0))
    throw BadInput(say(words().vanishing_time_step, fmt::arg("limit", called(least.name, Naming::limit)),
                       fmt::arg("formula", least.formula), fmt::arg("dt", to_text(dt))));
  return dt;
}

}  // namespace clapotis
