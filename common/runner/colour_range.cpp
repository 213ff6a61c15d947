#include "common/runner/colour_range.hpp"

#include <cmath>
#include <tuple>

#include "common/runner/ticks.hpp"

namespace clapotis {
namespace {

/// The smallest of 1, 1.5, 2, 3, 5, 7.5 times a power of ten that is not below `value`.
double round_up(double value) {
  const double power = std::pow(10, std::floor(std::log10(value)));
  for (const double digit : {1.0, 1.5, 2.0, 3.0, 5.0, 7.5}) {
    if (value <= digit * power) return digit * power;
  }
  return 10 * power;
}

std::pair<double, double> rounded(double lo, double hi) {
  if (lo == 0) return {0, round_up(hi)};
  if (lo == -hi) return {-round_up(hi), round_up(hi)};
  const double step = nice_ticks(lo, hi).step;
  return {step * std::floor(lo / step), step * std::ceil(hi / step)};
}

}  // namespace

std::pair<double, double> ColourRange::follow(double lo, double hi) {
  const bool known = high_ > low_;
  const bool usable = std::isfinite(lo) && std::isfinite(hi) && hi > lo;
  if (known && (locked || !usable)) return {low_, high_};
  if (!usable) return {lo, hi};
  const bool fits = lo >= low_ && hi <= high_, used = hi - lo >= (high_ - low_) / 3;
  if (!known || !fits || !used) std::tie(low_, high_) = rounded(lo, hi);
  return {low_, high_};
}

}  // namespace clapotis
