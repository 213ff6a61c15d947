#pragma once

#include <string>
#include <vector>

#include "common/runner/ink.hpp"

namespace clapotis {

struct Curve {
  std::string label;  ///< none: no key for it
  Colour colour = ink::palette().curves[0];
  std::vector<double> xs,
      ys;  ///< same size; xs grow; the curve has a gap at a NaN, infinity, or <= 0 when log_y
  bool dashed = false;
};

/// Upright bars from zero, each with a dot at its end: single contributions.
struct Bars {
  std::string label;
  Colour colour = ink::palette().curves[0];
  std::vector<double> xs, ys;  ///< same size
};

/// Curves and bars over a common abscissa. The words come from the caller.
struct Plot {
  std::string title;    ///< "Energies"
  std::string x_label;  ///< "t [s]"
  std::string y_label;  ///< "E [J]"
  std::vector<Curve> curves;
  bool log_y = false;
  std::vector<Bars> bars = {};  ///< below the curves
};

/// Fills `area`: title and curve labels above, axes with round ticks, curves on a light grid. A curve of a
/// million points keeps its extremes: each pixel column shows its first, least, greatest and last point.
/// Throws std::invalid_argument when the xs and ys of a curve or of bars differ in size. A curve without a
/// label is not in the key.
void paint(Canvas& canvas, const Plot& plot, const Box& area, double scale = 1);

}  // namespace clapotis
