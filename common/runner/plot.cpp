#include "common/runner/plot.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>

#include "common/runner/ink.hpp"
#include "common/runner/plot_axes.hpp"

namespace clapotis {
namespace {

constexpr double row_height = 26;

/// The points of one pixel column that its curve passes through.
class Column {
 public:
  [[nodiscard]] bool holds(Point p) const { return count_ > 0 && std::floor(p.x) == std::floor(first_.x); }

  void add(Point p) {
    if (count_++ == 0) first_ = least_ = greatest_ = p;
    if (p.y < least_.y) least_ = p;
    if (p.y > greatest_.y) greatest_ = p;
    last_ = p;
  }

  void move_to(std::vector<Point>& path) {
    if (count_ == 0) return;
    path.push_back(first_);
    if (count_ > 2) {
      const bool falls = least_.x < greatest_.x;
      path.push_back(falls ? least_ : greatest_);
      path.push_back(falls ? greatest_ : least_);
    }
    if (count_ > 1) path.push_back(last_);
    count_ = 0;
  }

 private:
  Point first_, least_, greatest_, last_;
  long count_ = 0;
};

/// Cuts a path into dashes; `ends` takes them as pairs of points.
void dash(const std::vector<Point>& path, double on, double off, std::vector<Point>& ends) {
  double walked = 0;  // since the last dash began
  for (std::size_t k = 0; k + 1 < path.size(); ++k) {
    const Point a = path[k], b = path[k + 1];
    const double length = std::hypot(b.x - a.x, b.y - a.y);
    const auto along = [&](double s) {
      return Point{a.x + (b.x - a.x) * s / length, a.y + (b.y - a.y) * s / length};
    };
    for (double s = 0; s < length;) {
      const bool painted = walked < on;
      const double piece = std::min(length - s, (painted ? on : on + off) - walked);
      if (painted) ends.insert(ends.end(), {along(s), along(s + piece)});
      s += piece;
      walked += piece;
      if (walked >= on + off - 1e-9) walked = 0;
      if (piece < 1e-9) break;
    }
  }
}

class CurvePainter {
 public:
  CurvePainter(Canvas& canvas, const PlotFrame& frame, double scale)
      : canvas_(canvas), frame_(frame), scale_(scale) {}

  void paint(const Plot& plot, const Curve& curve) {
    for (std::size_t k = 0; k < curve.xs.size(); ++k) {
      const Point p{frame_.pixel_x(curve.xs[k]), frame_.pixel_y(ordinate(plot, curve.ys[k]))};
      const bool is_gap = !std::isfinite(p.x) || !std::isfinite(p.y);
      if (is_gap || !column_.holds(p)) column_.move_to(path_);
      if (is_gap) {
        paint_path(curve);
      } else {
        column_.add(p);
      }
    }
    column_.move_to(path_);
    paint_path(curve);
  }

 private:
  void paint_path(const Curve& curve) {
    const double width = 3 * scale_;
    if (path_.size() == 1) canvas_.discs(std::array{Disc{path_.front(), width, curve.colour}});
    if (path_.size() > 1 && !curve.dashed) canvas_.line(path_, curve.colour, width);
    if (path_.size() > 1 && curve.dashed) {
      dashes_.clear();
      dash(path_, 12 * scale_, 8 * scale_, dashes_);
      canvas_.segments(dashes_, curve.colour, width);
    }
    path_.clear();
  }

  Canvas& canvas_;
  const PlotFrame& frame_;
  double scale_;
  Column column_;
  std::vector<Point> path_, dashes_;
};

void paint_bars(Canvas& canvas, const Plot& plot, const Bars& bars, const PlotFrame& frame, double scale) {
  std::vector<Point> ends;
  std::vector<Disc> dots;
  const double zero = plot.log_y ? frame.box.corner.y + frame.box.extent.y : frame.pixel_y(0);
  for (std::size_t k = 0; k < bars.xs.size(); ++k) {
    const Point tip{frame.pixel_x(bars.xs[k]), frame.pixel_y(ordinate(plot, bars.ys[k]))};
    if (!std::isfinite(tip.x) || !std::isfinite(tip.y)) continue;
    ends.insert(ends.end(), {Point{tip.x, zero}, tip});
    dots.push_back({tip, 4.5 * scale, bars.colour});
  }
  canvas.segments(ends, bars.colour, 2.5 * scale);
  canvas.discs(dots);
}

/// What the key says of a curve, or of bars.
struct Key {
  std::string_view label;
  Colour colour;
  enum class Sign { line, dashes, dot } sign;
};

std::vector<Key> keys_of(const Plot& plot) {
  std::vector<Key> keys;
  for (const Curve& curve : plot.curves)
    if (!curve.label.empty())
      keys.push_back({curve.label, curve.colour, curve.dashed ? Key::Sign::dashes : Key::Sign::line});
  for (const Bars& bars : plot.bars)
    if (!bars.label.empty()) keys.push_back({bars.label, bars.colour, Key::Sign::dot});
  return keys;
}

double sign_width(const Key& key) { return key.sign == Key::Sign::dot ? 12 : 36; }

double key_width(const Canvas& canvas, const Key& key, double scale) {
  return (sign_width(key) + 8 + 22) * scale + canvas.text_width(key.label, ink::numbers * scale);
}

void paint_sign(Canvas& canvas, const Key& key, double x, double end, double middle, double scale) {
  if (key.sign == Key::Sign::dot) {
    canvas.discs(std::array{Disc{{(x + end) / 2, middle}, 5.5 * scale, key.colour}});
  } else if (key.sign == Key::Sign::dashes) {
    canvas.segments(std::array{Point{x, middle}, Point{x + 14 * scale, middle},
                               Point{end - 14 * scale, middle}, Point{end, middle}},
                    key.colour, 4 * scale);
  } else {
    canvas.segments(std::array{Point{x, middle}, Point{end, middle}}, key.colour, 4 * scale);
  }
}

/// Labels in a row that ends at `right`, or as many rows as they need; the height of all rows.
double paint_keys(Canvas& canvas, const Plot& plot, const Box& area, double title_end, double scale) {
  const auto keys = keys_of(plot);
  double needed = 0;
  for (const Key& key : keys) needed += key_width(canvas, key, scale);
  const double left = area.corner.x + ink::margin * scale, right = area.corner.x + area.extent.x;
  const bool beside_title = title_end + needed <= right;
  double x = beside_title ? right - needed : left, row = beside_title ? 1 : 2;
  for (const Key& key : keys) {
    const double width = key_width(canvas, key, scale);
    if (x + width > right + 1 && x > left) x = left, ++row;
    const double baseline = area.corner.y + row * row_height * scale - 6 * scale,
                 middle = baseline - 6 * scale;
    const double end = x + sign_width(key) * scale;
    paint_sign(canvas, key, x, end, middle, scale);
    ink::fitted_text(canvas, {end + 8 * scale, baseline}, key.label, ink::numbers * scale,
                     right - end - 8 * scale, ink::text);
    x += width;
  }
  return row * row_height * scale;
}

}  // namespace

void paint(Canvas& canvas, const Plot& plot, const Box& area, double scale) {
  for (const Curve& curve : plot.curves) {
    if (curve.xs.size() != curve.ys.size()) {
      throw std::invalid_argument("curve \"" + curve.label + "\" needs as many ys as xs");
    }
  }
  for (const Bars& bars : plot.bars) {
    if (bars.xs.size() != bars.ys.size()) {
      throw std::invalid_argument("bars \"" + bars.label + "\" need as many ys as xs");
    }
  }
  canvas.rectangle(area, ink::sheet);
  const double height = ink::words * scale, baseline = area.corner.y + (row_height - 6) * scale;
  const double left = area.corner.x + ink::margin * scale, room = area.extent.x - 2 * ink::margin * scale;
  const double title_width = std::min(room, canvas.text_width(plot.title, height));
  ink::fitted_text(canvas, {left, baseline}, plot.title, height, room, ink::text);
  const double y_label_at = left + title_width + 14 * scale;
  ink::fitted_text(canvas, {y_label_at, baseline}, plot.y_label, ink::numbers * scale,
                   left + room - y_label_at, ink::faint_text);
  const double title_end = y_label_at + canvas.text_width(plot.y_label, ink::numbers * scale) + 20 * scale;
  const double rows = paint_keys(canvas, plot, area, title_end, scale);
  const Box rest{{area.corner.x, area.corner.y + rows}, {area.extent.x, area.extent.y - rows}};
  const PlotFrame frame = paint_axes(canvas, plot, rest, scale);
  canvas.clip(frame.box);
  for (const Bars& bars : plot.bars) paint_bars(canvas, plot, bars, frame, scale);
  CurvePainter painter(canvas, frame, scale);
  for (const Curve& curve : plot.curves) painter.paint(plot, curve);
  canvas.unclip();
}

}  // namespace clapotis
