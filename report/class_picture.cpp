#include "report/class_picture.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <stdexcept>
#include <tuple>
#include <utility>

#include "common/runner/ink.hpp"

namespace clapotis {
namespace {

const Box& box_of(const std::vector<Place>& places, std::type_index type) {
  for (const auto& place : places)
    if (std::ranges::find(place.types, type) != place.types.end()) return place.box;
  throw std::logic_error(std::string("no box for ") + type.name());
}

struct Stretch {
  double from, to;
};
Stretch across(const Box& box) { return {box.corner.x, box.corner.x + box.extent.x}; }
Stretch down(const Box& box) { return {box.corner.y, box.corner.y + box.extent.y}; }

/// Where along one axis a line leaves one box and meets the other: the middle of what they share, or else
/// near the corners that face each other, or on the sides that do.
std::pair<double, double> ends(const Stretch& a, const Stretch& b, double inside) {
  const double from = std::max(a.from, b.from), to = std::min(a.to, b.to);
  if (from < to) return {(from + to) / 2, (from + to) / 2};
  return a.to <= b.from ? std::pair(a.to - inside, b.from + inside)
                        : std::pair(a.from + inside, b.to - inside);
}

// ---- Painting ----

const Colour arrow_colour = ink::translucent(ink::text, 0.75F);

void paint_head(Canvas& canvas, const Point& tip, const Point& along, bool closed) {
  constexpr double length = 5, half_width = 2.4;
  const auto at = [&](double back, double side) {
    return Point{tip.x - back * along.x - side * along.y, tip.y - back * along.y + side * along.x};
  };
  std::vector<Point> head{at(length, half_width), tip, at(length, -half_width)};
  if (closed) head.push_back(head.front());
  canvas.line(head, arrow_colour, 0.7);
}

void paint_line(Canvas& canvas, const Point& from, const Point& to, Kind kind) {
  const double length = std::hypot(to.x - from.x, to.y - from.y);
  const Point along{(to.x - from.x) / length, (to.y - from.y) / length};
  const auto at = [&](double way) { return Point{from.x + way * along.x, from.y + way * along.y}; };
  constexpr double dash = 2.2, gap = 1.6;
  std::vector<Point> pieces;
  if (kind == Kind::takes) {
    for (double way = 0; way < length; way += dash + gap)
      pieces.insert(pieces.end(), {at(way), at(std::min(way + dash, length))});
  } else {
    pieces = {from, kind == Kind::derives ? at(length - 5) : to};
  }
  canvas.segments(pieces, arrow_colour, 0.7);
  paint_head(canvas, to, along, kind == Kind::derives);
}

void paint_arrow(Canvas& canvas, const Box& from, const Box& to, Kind kind) {
  const auto y = ends(down(from), down(to), 0);
  const bool beside = y.first == y.second;
  const auto x = ends(across(from), across(to), beside ? 0 : 7);
  paint_line(canvas, {x.first, y.first}, {x.second, y.second}, kind);
}

void paint_place(Canvas& canvas, const Place& place) {
  ink::paper_box(canvas, place.box, ink::wall, 0.7);
  double y = place.box.corner.y + 3 + text_height;
  for (const auto& name : place.names) {
    ink::fitted_text(canvas, {place.box.corner.x + place.box.extent.x / 2, y}, name, text_height,
                     place.box.extent.x - 4, ink::text, Align::centre);
    y += line_height;
  }
}

}  // namespace

double paint_laws(Canvas& canvas, const Point& at, const std::string& title,
                  const std::vector<LawLine>& laws) {
  constexpr double to_hooks = 63, law_height = 7.8;
  const double right = sheet_size.x - 2;
  canvas.text({at.x, at.y + text_height}, title, text_height, ink::text);
  canvas.text({right, at.y + text_height}, "hooks", small_text, ink::faint_text, Align::right);
  double y = at.y + text_height + 3;
  canvas.segments(std::vector<Point>{{at.x, y}, {right, y}}, ink::wall, 0.5);
  for (const auto& [name, hooks] : laws) {
    canvas.text({at.x, y + law_height}, name, small_text, ink::text);
    for (const auto& line : ink::broken(canvas, hooks, small_text, right - at.x - to_hooks))
      canvas.text({at.x + to_hooks, y += law_height}, line, small_text, ink::faint_text);
  }
  return y;
}

void paint_key(Canvas& canvas, double left) {
  const double y = sheet_size.y - 6;
  double x = left;
  for (const auto& [kind, what] : {std::pair{Kind::gives, "calls, has or makes"},
                                   std::pair{Kind::takes, "is given"}, std::pair{Kind::derives, "is a"}}) {
    paint_line(canvas, {x, y - 2.5}, {x + 22, y - 2.5}, kind);
    canvas.text({x + 26, y}, what, small_text, ink::text);
    x += 40 + canvas.text_width(what, small_text);
  }
}

void paint_boxes(Canvas& canvas, const std::vector<Place>& places, const std::vector<Arrow>& arrows) {
  std::vector<std::tuple<const Box*, const Box*, Kind>> painted;  // types in one box have one arrow
  for (const auto& [from, to, kind] : arrows) {
    const std::tuple arrow(&box_of(places, from), &box_of(places, to), kind);
    if (std::ranges::find(painted, arrow) != painted.end()) continue;
    painted.push_back(arrow);
    paint_arrow(canvas, *std::get<0>(arrow), *std::get<1>(arrow), kind);
  }
  for (const auto& place : places) paint_place(canvas, place);
}

}  // namespace clapotis
