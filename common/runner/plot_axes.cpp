#include "common/runner/plot_axes.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "common/runner/ink.hpp"

namespace clapotis {
namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

void include(AxisRange& range, double value) {
  range.lo = std::min(range.lo, value);
  range.hi = std::max(range.hi, value);
}

/// Energies that change by less than this share are painted as the constants they are, not as magnified
/// rounding.
constexpr double least_relative_height = 1e-3;

AxisRange roomy(AxisRange y) {
  if (!(y.lo <= y.hi) || (y.lo == 0 && y.hi == 0)) return {0, 1};
  const double least = least_relative_height * std::max(std::abs(y.lo), std::abs(y.hi));
  const double height = std::max({y.hi - y.lo, least, 1e-300});
  const double middle = (y.lo + y.hi) / 2;
  AxisRange range{middle - 0.56 * height, middle + 0.56 * height};
  if (y.lo >= 0 && y.lo < 0.3 * height)
    range.lo = 0;  // zero tells how large a value is: show it when it is near
  if (y.hi <= 0 && -y.hi < 0.3 * height) range.hi = 0;
  return range;
}

/// Whole decades, for y is already a logarithm; `lowest_top` is the greatest value of the lowest curve.
AxisRange whole_decades(AxisRange y, double lowest_top) {
  if (!(y.lo <= y.hi)) return {-1, 0};
  // An error that begins at rounding must not press its later course into a line.
  constexpr double most_decades = 6, most_of_all = 14;
  const double below = std::max(lowest_top - most_decades, y.hi - most_of_all);
  const AxisRange range{std::max(std::floor(y.lo), std::ceil(below)), std::ceil(y.hi)};
  return range.hi > range.lo ? range : AxisRange{range.lo - 1, range.hi + 1};
}

Ticks decade_ticks(const AxisRange& y, int at_most) {
  for (double step = 1;; ++step) {
    const double first = std::ceil(y.lo / step), last = std::floor(y.hi / step);
    if (last - first < at_most) return {first * step, step, static_cast<int>(last - first) + 1};
  }
}

std::string y_label(const Plot& plot, const Ticks& ticks, int k) {
  if (!plot.log_y) return tick_label(ticks[k], ticks.step);
  const double value = std::pow(10.0, ticks[k]);
  return tick_label(value, value);
}

double widest_label(const Canvas& canvas, const Plot& plot, const Ticks& ticks, double height) {
  double widest = 0;
  for (int k = 0; k < ticks.count; ++k)
    widest = std::max(widest, canvas.text_width(y_label(plot, ticks, k), height));
  return widest;
}

void paint_y_axis(Canvas& canvas, const Plot& plot, const PlotFrame& frame, const Ticks& ticks,
                  double scale) {
  const double left = frame.box.corner.x, right = left + frame.box.extent.x, height = ink::numbers * scale;
  for (int k = 0; k < ticks.count; ++k) {
    const double y = frame.pixel_y(ticks[k]);
    canvas.segments(std::array{Point{left, y}, Point{right, y}}, ink::grid, scale);
    canvas.text({left - 8 * scale, y + 0.36 * height}, y_label(plot, ticks, k), height, ink::text,
                Align::right);
  }
}

void paint_x_axis(Canvas& canvas, const Plot& plot, const PlotFrame& frame, double scale) {
  const double height = ink::numbers * scale, top = frame.box.corner.y, bottom = top + frame.box.extent.y;
  const double right = frame.box.corner.x + frame.box.extent.x, baseline = bottom + 6 * scale + height;
  const double free_until = right - canvas.text_width(plot.x_label, height) - height;
  const int at_most = std::clamp(static_cast<int>(frame.box.extent.x / (75 * scale)), 3, 7);
  const Ticks ticks = nice_ticks(frame.ranges.x.lo, frame.ranges.x.hi, at_most);
  for (int k = 0; k < ticks.count; ++k) {
    const double x = frame.pixel_x(ticks[k]);
    const std::string label = tick_label(ticks[k], ticks.step);
    canvas.segments(std::array{Point{x, top}, Point{x, bottom}}, ink::grid, scale);
    if (x + canvas.text_width(label, height) / 2 > free_until) continue;
    canvas.text({x, baseline}, label, height, ink::text, Align::centre);
  }
  canvas.text({right, baseline}, plot.x_label, height, ink::faint_text, Align::right);
}

}  // namespace

double ordinate(const Plot& plot, double y) {
  if (!std::isfinite(y) || (plot.log_y && y <= 0)) return std::numeric_limits<double>::quiet_NaN();
  return plot.log_y ? std::log10(y) : y;
}

PlotRanges ranges_of(const Plot& plot) {
  AxisRange x{infinity, -infinity}, y{infinity, -infinity};
  double lowest_top = infinity;
  const auto include_all = [&](const std::vector<double>& xs, const std::vector<double>& ys) {
    AxisRange own{infinity, -infinity};
    for (std::size_t k = 0; k < xs.size(); ++k) {
      if (std::isfinite(xs[k])) include(x, xs[k]);
      if (std::isfinite(ys[k]) && (!plot.log_y || ys[k] > 0)) include(own, ys[k]);
    }
    if (!(own.lo <= own.hi)) return;
    y = {std::min(y.lo, own.lo), std::max(y.hi, own.hi)};
    lowest_top = std::min(lowest_top, own.hi);
  };
  for (const Curve& curve : plot.curves) include_all(curve.xs, curve.ys);
  for (const Bars& bars : plot.bars) include_all(bars.xs, bars.ys);
  if (!(x.lo <= x.hi)) x = {0, 1};
  if (x.lo == x.hi) x.hi = x.lo + std::max(1.0, std::abs(x.lo));  // a run that has just begun
  if (!plot.log_y) return {x, roomy(y)};
  return {x, whole_decades({std::log10(y.lo), std::log10(y.hi)}, std::log10(lowest_top))};
}

PlotFrame paint_axes(Canvas& canvas, const Plot& plot, const Box& area, double scale) {
  const double height = ink::numbers * scale;
  const double bottom = height + 18 * scale, top = height / 2, right = ink::margin * scale;
  PlotFrame frame{ranges_of(plot), {}};
  const double inner = std::max(1.0, area.extent.y - top - bottom);
  const int at_most = std::clamp(static_cast<int>(inner / (34 * scale)), 3, 5);
  const auto& y = frame.ranges.y;
  const Ticks ticks = plot.log_y ? decade_ticks(y, at_most) : nice_ticks(y.lo, y.hi, at_most);
  const double left =
      ink::margin * scale + std::max(48 * scale, widest_label(canvas, plot, ticks, height)) + 8 * scale;
  frame.box = {{area.corner.x + left, area.corner.y + top},
               {std::max(1.0, area.extent.x - left - right), inner}};
  canvas.rectangle(frame.box, ink::paper);
  paint_y_axis(canvas, plot, frame, ticks, scale);
  paint_x_axis(canvas, plot, frame, scale);
  const Point corner = frame.box.corner, end{corner.x + frame.box.extent.x, corner.y + frame.box.extent.y};
  canvas.line(std::array{corner, Point{corner.x, end.y}, end}, ink::wall, 2 * scale);
  return frame;
}

}  // namespace clapotis
