#pragma once

#include <cmath>
#include <sstream>
#include <stdexcept>
#include <string_view>

namespace clapotis {

/// Refuses an input of a reference solution: throws std::invalid_argument with a sentence that names
/// the solution, the quantity, the value it had and the range it must lie in.
inline void require(bool holds, std::string_view where, std::string_view name, double value,
                    std::string_view range) {
  if (holds) return;
  std::ostringstream sentence;
  sentence.precision(17);
  sentence << where << ": " << name << " is " << value << ", it must be " << range;
  throw std::invalid_argument(sentence.str());
}

/// The usual demands on the inputs of the solution `where`.
struct Demand {
  std::string_view where;

  void finite(double value, std::string_view name) const {
    require(std::isfinite(value), where, name, value, "finite");
  }
  void positive(double value, std::string_view name) const {
    require(value > 0 && std::isfinite(value), where, name, value, "finite and > 0");
  }
  void not_negative(double value, std::string_view name) const {
    require(value >= 0 && std::isfinite(value), where, name, value, "finite and >= 0");
  }
};

}  // namespace clapotis
