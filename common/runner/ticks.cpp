#include "common/runner/ticks.hpp"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <string_view>

namespace clapotis {
namespace {

/// Forgives the rounding of lo / step: an end of the range that is a tick is one.
constexpr double slack = 1e-9;

std::string written(double value, std::chars_format format, int decimals) {
  std::array<char, 64> digits{};
  const auto end = std::to_chars(digits.data(), digits.data() + digits.size(), value, format, decimals);
  return {digits.data(), end.ptr};
}

/// "2.5e-06" -> "2.5e-6", "1e+05" -> "1e5"
std::string with_short_exponent(const std::string& text) {
  const auto e = text.find('e');
  if (e == std::string::npos) return text;
  const auto digits = std::min(text.find_first_not_of("+-0", e + 1), text.size());
  return text.substr(0, e + 1) + (text[e + 1] == '-' ? "-" : "") + text.substr(digits);
}

int power_of_ten(double value) { return static_cast<int>(std::floor(std::log10(value) + slack)); }

bool is_whole(double value) { return std::abs(value - std::round(value)) < 1e-6; }

}  // namespace

double Ticks::operator[](int k) const {
  const double value = first + k * step;
  return std::abs(value) < slack * step ? 0.0 : value;  // no "-0", no 1e-17 in the place of zero
}

Ticks nice_ticks(double lo, double hi, int at_most) {
  if (!std::isfinite(hi - lo) || hi <= lo) return {};
  const double coarse = (hi - lo) / at_most;
  for (double decade = std::pow(10.0, power_of_ten(coarse) - 1);; decade *= 10) {
    for (const double mantissa : {1.0, 2.0, 2.5, 5.0}) {
      const double step = mantissa * decade;
      const double first = std::ceil(lo / step - slack), last = std::floor(hi / step + slack);
      if (last - first < at_most) return {first * step, step, static_cast<int>(last - first) + 1};
    }
  }
}

double nice_length(double length) {
  const double decade = std::pow(10.0, power_of_ten(length));
  for (const double mantissa : {5.0, 2.0}) {
    if (mantissa * decade <= length * (1 + slack)) return mantissa * decade;
  }
  return decade;
}

std::string two_digits(double value) {
  const double size = std::abs(value);
  if (size < 1) return written(value, std::chars_format::general, 2);
  return written(value, std::chars_format::fixed, size < 10 ? 1 : 0);
}

std::string three_digits(double value) {
  return with_short_exponent(written(value, std::chars_format::scientific, 2));
}

std::string tick_label(double value, double step) {
  if (value == 0) return "0";
  const double size = std::abs(value);
  const int decimals_of_step = [&] {  // 0.25 has one more digit than 0.2
    const int digits = -power_of_ten(step);
    return is_whole(step * std::pow(10.0, digits)) ? digits : digits + 1;
  }();
  if (size >= 1e5 || (size < 1e-3 && step < 1e-3)) {
    const int decimals = std::max(0, power_of_ten(size) + decimals_of_step);
    return with_short_exponent(written(value, std::chars_format::scientific, decimals));
  }
  return written(value, std::chars_format::fixed, std::max(0, decimals_of_step));
}

std::string grouped(long long count, std::string_view space) {
  auto digits = std::to_string(count);
  for (auto at = static_cast<std::ptrdiff_t>(digits.size()) - 3; at > 0; at -= 3)
    digits.insert(static_cast<std::size_t>(at), space);
  return digits;
}

}  // namespace clapotis
