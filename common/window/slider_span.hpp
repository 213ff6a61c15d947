#pragma once

#include "common/simulation/simulation.hpp"

namespace clapotis {

/// From where to where a slider goes: the allowed range where it is bounded, else around the scene's own
/// value. What lies beyond, but is allowed, can be typed.
struct SliderSpan {
  double low = 0, high = 1;
  bool logarithmic = false;
};

/// `home` is the parameter with the value the scene gives it, `value` its present one, which is always
/// within.
SliderSpan slider_span(const Parameter& home, double value, const Simulation& simulation);

/// The allowed values in the little room beside a slider: "≥ 0", "0 … 1"; empty for any number.
std::string short_range(const Range& range);

/// "px/s^2" as it is printed: "px/s²", with the scene's unit of length for L.
std::string printed_unit(const Parameter& parameter, const std::string& length_unit);

/// "x0" as it is printed: "x₀"; "beta": "β". The parameter's name where it has no symbol.
std::string printed_symbol(const Parameter& parameter);

/// A value in few digits: "150000", "0.0123", "1.5e+08".
std::string short_number(double value);

}  // namespace clapotis
