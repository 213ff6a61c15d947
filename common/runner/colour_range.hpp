#pragma once

#include <utility>

namespace clapotis {

/// A range of colours that does not flicker: between round numbers, growing at once with what is shown and
/// shrinking only when less than a third of it is used. Or the range that was locked.
class ColourRange {
 public:
  /// The range for values between lo and hi. An end that is 0, and ends that are opposite, remain so.
  std::pair<double, double> follow(double lo, double hi);
  bool locked = false;

 private:
  double low_ = 0, high_ = 0;
};

}  // namespace clapotis
