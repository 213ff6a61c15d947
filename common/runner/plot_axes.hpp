#pragma once

#include "common/runner/plot.hpp"
#include "common/runner/ticks.hpp"

namespace clapotis {

struct AxisRange {
  double lo = 0, hi = 1;
};

/// What the axes of a plot span; y is log10(y) when the plot is logarithmic.
struct PlotRanges {
  AxisRange x, y;
};

/// Around all points that can be painted; never empty: a constant is given room, no points give [0, 1].
[[nodiscard]] PlotRanges ranges_of(const Plot& plot);

/// The ordinate as it is painted: y, or log10(y), NaN where there is none.
[[nodiscard]] double ordinate(const Plot& plot, double y);

/// Where the curves are painted: from the ranges to pixels.
struct PlotFrame {
  PlotRanges ranges;
  Box box;

  [[nodiscard]] double pixel_x(double x) const {
    return box.corner.x + (x - ranges.x.lo) / (ranges.x.hi - ranges.x.lo) * box.extent.x;
  }
  [[nodiscard]] double pixel_y(double y) const {
    return box.corner.y + (ranges.y.hi - y) / (ranges.y.hi - ranges.y.lo) * box.extent.y;
  }
};

/// Grid, ticks, tick labels and the abscissa's label; says where the curves belong: within `area`, whose top
/// is free.
[[nodiscard]] PlotFrame paint_axes(Canvas& canvas, const Plot& plot, const Box& area, double scale);

}  // namespace clapotis
