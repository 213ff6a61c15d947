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

/// Curves over a common abscissa. The words come from the caller.
struct Plot {
  std::string title;    ///< "Energies"
  std::string x_label;  ///< "t [s]"
  std::string y_label;  ///< "E [J]"
  std::vector<Curve> curves;
  bool log_y = false;
};

/// Fills `area`: title and curve labels above, axes with round ticks, curves on a light grid. A curve of a
/// million points keeps its extremes: each pixel column shows its first, least, greatest and last point.
/// Throws std::invalid_argument when a curve's xs and ys differ in size.
void paint(Canvas& canvas, const Plot& plot, const Box& area, double scale = 1);

}  // namespace clapotis
