#pragma once

#include <string>
#include <string_view>

namespace clapotis {

/// Round values first, first + step, ... (count of them): what an axis, a colour bar or a ruler is marked
/// with.
struct Ticks {
  double first = 0, step = 1;
  int count = 0;
  [[nodiscard]] double operator[](int k) const;
};

/// As many multiples of 1, 2, 2.5 or 5 times a power of ten as lie in [lo, hi], at most `at_most` (>= 3) and
/// at least 3 when `at_most` is 5 or more. A range that is empty or not finite has no ticks.
[[nodiscard]] Ticks nice_ticks(double lo, double hi, int at_most = 5);

/// The largest of 1, 2 or 5 times a power of ten that is not above `length` (> 0).
[[nodiscard]] double nice_length(double length);

/// `value` with the decimals that tell it from value + step: "0.15", "200", "3e-6". Always a dot, whatever
/// the locale.
[[nodiscard]] std::string tick_label(double value, double step);

/// "0.034", "1.6", "120": how many times as much.
[[nodiscard]] std::string two_digits(double value);

/// Three digits in always the same width while the power of ten is the same: "1.05e-3".
[[nodiscard]] std::string three_digits(double value);

/// 1234567 as 1 234 567, with narrow spaces, or others where a font lacks them.
[[nodiscard]] std::string grouped(long long count, std::string_view space = "\u2009");

}  // namespace clapotis
