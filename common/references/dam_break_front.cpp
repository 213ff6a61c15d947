#include "common/references/dam_break_front.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace clapotis {

double FrontExperiment::front(double time) const {
  const bool covered = !readings.empty() && time >= readings.front().time && time <= readings.back().time;
  if (!covered) return std::numeric_limits<double>::quiet_NaN();
  const auto after = std::ranges::lower_bound(readings, time, {}, &FrontReading::time);
  if (after == readings.begin()) return after->front;
  const auto before = after - 1;
  return std::lerp(before->front, after->front, (time - before->time) / (after->time - before->time));
}

}  // namespace clapotis
