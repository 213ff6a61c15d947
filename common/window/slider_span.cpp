#include "common/window/slider_span.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "common/runner/units.hpp"
#include "common/words.hpp"

namespace clapotis {
namespace {

constexpr std::array<std::pair<std::string_view, std::string_view>, 10> greek{{{"alpha", "α"},
                                                                               {"beta", "β"},
                                                                               {"gamma", "γ"},
                                                                               {"delta", "δ"},
                                                                               {"epsilon", "ε"},
                                                                               {"mu", "μ"},
                                                                               {"nu", "ν"},
                                                                               {"rho", "ρ"},
                                                                               {"sigma", "σ"},
                                                                               {"omega", "ω"}}};

/// What a value may reasonably be where neither range nor default tells: a length of the scene, its greatest
/// speed.
double reach_of(const Parameter& home, const Simulation& simulation) {
  const auto& view = simulation.setup().view;
  const auto& length = simulation.scene().length_unit;
  if (home.unit == length) return std::max(view.right - view.left, view.top - view.bottom);
  if (home.unit == length + "/s") return simulation.sound_speed() / 5;  // c = 10 v_max
  return 1;
}

SliderSpan span_of(const Parameter& home, double at, const Simulation& simulation) {
  const auto& range = home.range;
  const bool from_zero = range.low == 0, bounded = range.low > any_number.low && range.high <= 1e6;
  if (bounded) {
    const double smallest = range.low_excluded ? (range.high - range.low) / 1000 : 0;
    return {range.low + smallest, range.high, false};
  }
  if (home.integer && range.low >= 1) return {std::max(range.low, std::floor(at / 100)), 10 * at, true};
  if (from_zero && range.low_excluded) return {at / 100, at * 100, true};
  const double reach = at != 0 ? 4 * std::abs(at) : reach_of(home, simulation);
  if (from_zero) return {0, reach, false};
  const double both = std::max(reach_of(home, simulation), std::abs(at));
  return {-both, both, false};
}

}  // namespace

SliderSpan slider_span(const Parameter& home, double value, const Simulation& simulation) {
  const double at = std::isfinite(home.value) ? home.value : value;
  auto span = span_of(home, at, simulation);
  span.low = std::min(span.low, value);
  span.high = std::max(span.high, value);
  return span;
}

std::string short_number(double value) {
  const double size = std::abs(value);
  return size >= 1e4 && size < 1e7 ? fmt::format("{:.0f}", value) : fmt::format("{:.4g}", value);
}

std::string short_range(const Range& range) {
  const bool low = range.low > any_number.low, high = range.high <= 1e6;
  if (low && high) return short_number(range.low) + " … " + short_number(range.high);
  if (low) return (range.low_excluded ? "> " : "≥ ") + short_number(range.low);
  if (high) return "≤ " + short_number(range.high);
  return {};
}

std::string printed_unit(const Parameter& parameter, const std::string& length_unit) {
  return printed(with_length(parameter.unit, length_unit));
}

std::string printed_symbol(const Parameter& parameter) {
  std::string text = parameter.symbol.empty() ? parameter.name : parameter.symbol;
  for (const auto& [name, letter] : greek) {
    if (!text.starts_with(name)) continue;
    text.replace(0, name.size(), letter);
    break;
  }
  for (const std::string_view zero : {"_0", "0"})
    if (text.size() > zero.size() && text.ends_with(zero))
      return text.substr(0, text.size() - zero.size()) + "₀";
  return text;
}

}  // namespace clapotis
