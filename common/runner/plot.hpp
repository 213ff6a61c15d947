#pragma once

#include <array>
#include <string>
#include <vector>

#include "common/runner/canvas.hpp"

namespace clapotis {

/// Colours for curves that the colour-blind can tell apart: M. Okabe and K. Ito, Color Universal Design
/// (2008).
inline constexpr std::array<Colour, 6> curve_colours{{{0.000F, 0.447F, 0.698F},    // blue
                                                      {0.835F, 0.369F, 0.000F},    // vermilion
                                                      {0.000F, 0.620F, 0.451F},    // bluish green
                                                      {0.800F, 0.475F, 0.655F},    // reddish purple
                                                      {0.902F, 0.624F, 0.000F},    // orange
                                                      {0.110F, 0.140F, 0.180F}}};  // near black

struct Curve {
  std::string label;
  Colour colour = curve_colours[0];
  std::vector<double> xs,
      ys;  ///< same size; xs grow; the curve has a gap at a NaN, infinity, or <= 0 when log_y
  bool dashed = false;
};

/// Upright bars from zero, each with a dot at its end: single contributions.
struct Bars {
  std::string label;
  Colour colour = curve_colours[0];
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
