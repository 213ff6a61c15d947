#include "common/runner/legend.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "common/runner/ink.hpp"
#include "common/runner/ticks.hpp"

namespace clapotis {
namespace {

constexpr double bar_width = 340, bar_height = 20, bar_top = 16;
constexpr double one_row = 86, second_row = 58;

/// Title and colour bar stand side by side when there is room for both.
bool side_by_side(double width, double scale) { return width >= 1000 * scale; }

std::string with_unit(const std::string& label, const std::string& unit) {
  return unit.empty() ? label : label + " [" + unit + "]";
}

/// As many ticks as have labels that do not touch.
Ticks ticks_with_room(const Canvas& canvas, double lo, double hi, double width, double text_height) {
  for (int at_most = 5;; --at_most) {
    const Ticks ticks = nice_ticks(lo, hi, at_most);
    double widest = 0;
    for (int k = 0; k < ticks.count; ++k) {
      widest = std::max(widest, canvas.text_width(tick_label(ticks[k], ticks.step), text_height));
    }
    if (at_most == 2 || (widest + 2 * text_height) * (hi - lo) < width * ticks.step) return ticks;
  }
}

void paint_bar(Canvas& canvas, const ColourScale& colours, const Box& bar) {
  constexpr int bands = 85;  // their colours differ by less than the eye sees
  for (int k = 0; k < bands; ++k) {
    const double done = bar.extent.x * k / bands;  // each band reaches the end: no seam shows between two
    canvas.rectangle({{bar.corner.x + done, bar.corner.y}, {bar.extent.x - done, bar.extent.y}},
                     at(colours.map, (k + 0.5) / bands));
  }
}

void paint_bar_ticks(Canvas& canvas, const ColourScale& colours, const Box& bar, double scale) {
  const double height = ink::numbers * scale;
  const double bottom = bar.corner.y + bar.extent.y;
  const double baseline = bottom + 7 * scale + height;
  const Ticks ticks = ticks_with_room(canvas, colours.lo, colours.hi, bar.extent.x, height);
  const auto mark = [&](double x, const std::string& label) {
    canvas.line(std::array{Point{x, bottom}, Point{x, bottom + 6 * scale}}, ink::text, 2 * scale);
    const double last = bar.corner.x + bar.extent.x + 14 * scale - canvas.text_width(label, height) / 2;
    canvas.text({std::min(x, last), baseline}, label, height, ink::text, Align::centre);  // stay on the sheet
  };
  for (int k = 0; k < ticks.count; ++k) {
    const double share = (ticks[k] - colours.lo) / (colours.hi - colours.lo);
    mark(bar.corner.x + share * bar.extent.x, tick_label(ticks[k], ticks.step));
  }
  if (ticks.count == 0 && std::isfinite(colours.lo)) {  // every particle has the same value
    mark(bar.corner.x + bar.extent.x / 2, tick_label(colours.lo, std::abs(colours.lo) / 100));
  }
}

/// Its left end [pixel], the text included: what remains is the title's.
double paint_legend(Canvas& canvas, const Picture& picture, const PictureView& view) {
  const double scale = view.scale, right = view.area.corner.x + view.area.extent.x;
  const bool beside = side_by_side(view.area.extent.x, scale);
  const double top = view.area.corner.y + (beside ? bar_top : one_row - 4) * scale;
  const double end = right - ink::margin * scale;
  const double width = std::min(bar_width * scale, 0.6 * view.area.extent.x);
  const Box bar{{end - width, top}, {width, bar_height * scale}};
  paint_bar(canvas, picture.colours, bar);
  paint_bar_ticks(canvas, picture.colours, bar, scale);
  const auto label = with_unit(picture.colours.label, picture.colours.unit);
  const double height = ink::words * scale, label_end = bar.corner.x - 14 * scale;
  const double room = std::min(240 * scale, label_end - view.area.corner.x - ink::margin * scale);
  ink::fitted_text(canvas, {label_end, top + 17 * scale}, label, height, room, ink::text, Align::right);
  return beside ? label_end - std::min(room, canvas.text_width(label, height)) : right;
}

/// Ruler of a round length; its right end with the text [pixel].
double paint_ruler(Canvas& canvas, const Picture& picture, const PictureView& view, double middle) {
  const double scale = view.scale;
  const double length = nice_length(160 * scale / view.pixels_per_unit);
  const double left = view.area.corner.x + ink::margin * scale;
  const double right = left + length * view.pixels_per_unit, half = 7 * scale;
  canvas.segments(
      std::array{Point{left, middle}, Point{right, middle}, Point{left, middle - half},
                 Point{left, middle + half}, Point{right, middle - half}, Point{right, middle + half}},
      ink::text, 3 * scale);
  const std::string label = tick_label(length, length) + " " + picture.length_unit;
  const double height = ink::words * scale;
  canvas.text({right + 10 * scale, middle + 0.36 * height}, label, height, ink::text);
  return right + 10 * scale + canvas.text_width(label, height);
}

void paint_titles(Canvas& canvas, const std::string& title, const std::string& subtitle,
                  const PictureView& view, double end, const std::optional<Colour>& mark) {
  const double scale = view.scale;
  const Point corner = view.area.corner;
  double left = corner.x + ink::margin * scale;
  if (mark) {
    canvas.rectangle({{left, corner.y + 14 * scale}, {6 * scale, 60 * scale}}, *mark);
    left += 16 * scale;
  }
  const double room = end - ink::margin * scale - left;
  ink::fitted_text(canvas, {left, corner.y + 36 * scale}, title, ink::title * scale, room, ink::text);
  ink::fitted_text(canvas, {left, corner.y + 68 * scale}, subtitle, ink::words * scale, room,
                   ink::faint_text);
}

}  // namespace

double header_height(double width, double scale, bool has_colours) {
  return (side_by_side(width, scale) || !has_colours ? one_row : one_row + second_row) * scale;
}

double footer_height(double scale) { return 44 * scale; }

bool has_legend(const Picture& picture) { return picture.legend && picture.value.size() > 0; }

void paint_header(Canvas& canvas, const Picture& picture, const PictureView& view) {
  const double end =
      has_legend(picture) ? paint_legend(canvas, picture, view) : view.area.corner.x + view.area.extent.x;
  paint_titles(canvas, picture.title, picture.subtitle, view, end, picture.mark);
}

void paint_common_header(Canvas& canvas, const std::string& title, const std::string& subtitle,
                         const Picture& picture, const PictureView& view) {
  const double end = picture.value.size() > 0 ? paint_legend(canvas, picture, view)
                                              : view.area.corner.x + view.area.extent.x;
  paint_titles(canvas, title, subtitle, view, end, std::nullopt);
}

void paint_footer(Canvas& canvas, const Picture& picture, const PictureView& view) {
  const double scale = view.scale, height = ink::words * scale;
  const double middle = view.scene.corner.y + view.scene.extent.y + footer_height(scale) / 2;
  const double baseline = middle + 0.36 * height;
  const double right = view.area.corner.x + view.area.extent.x - ink::margin * scale;
  double x = paint_ruler(canvas, picture, view, middle);
  const auto key = [&](Colour colour, const std::string& label) {
    x += 24 * scale;
    const double radius = 9 * scale;
    canvas.discs(std::array{Disc{{x + radius, middle}, radius, colour, 0.6 * radius}});
    x += 2 * radius + 8 * scale;
    ink::fitted_text(canvas, {x, baseline}, label, height, right - x, ink::text);
    x += std::min(right - x, canvas.text_width(label, height));
  };
  if (picture.chosen && !picture.chosen->label.empty()) key(ink::chosen, picture.chosen->label);
  if (picture.chosen && !picture.chosen->in_vain.empty()) key(ink::in_vain, picture.chosen->in_vain_label);
}

}  // namespace clapotis
