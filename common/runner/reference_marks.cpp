#include "common/runner/reference_marks.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <string>
#include <utility>
#include <vector>

#include "common/runner/ink.hpp"

namespace clapotis {
namespace {

constexpr double smallest_ring = 5;  ///< radius of the ring of a particle of the reference [pixel]
constexpr double width = 2.5;        ///< of its lines [pixel]
constexpr double dot_radius = 4;     ///< radius of a point that was measured [pixel]
constexpr double mark_height = 90;   ///< of the staff of a mark, to where water is rare [pixel]

/// Translucent, so that what moves below it is not lost.
Colour behind_words() { return ink::translucent(ink::paper, 0.78F); }

bool is_number(Point at) { return std::isfinite(at.x) && std::isfinite(at.y); }

/// One line of the key: how something is drawn, and what it is.
struct KeyLine {
  enum class Sign { none, ring, line, dot } sign;
  std::string words;
};

std::vector<KeyLine> key_of(const Picture& picture) {
  using enum KeyLine::Sign;
  std::vector<KeyLine> lines;
  if (const auto& ghosts = picture.ghosts) {
    const bool particles = ghosts->shape == Shape::particles, marks = ghosts->shape == Shape::marks;
    if (!marks) lines.push_back({particles ? ring : line, ghosts->label});
    if (ghosts->measured_x.size() > 0) lines.push_back({KeyLine::Sign::dot, ghosts->measured_label});
  }
  if (!picture.note.empty()) lines.push_back({none, picture.note});
  return lines;
}

void paint_sign(Canvas& canvas, KeyLine::Sign sign, Point middle, double room, double scale) {
  const double radius = room / 3;
  if (sign == KeyLine::Sign::ring)
    canvas.discs(std::array{Disc{middle, radius, ink::ghost, radius - width * scale}});
  if (sign == KeyLine::Sign::dot)
    canvas.discs(std::array{Disc{middle, dot_radius * scale, ink::text},
                            Disc{middle, (dot_radius - 1.2) * scale, ink::paper}});
  if (sign == KeyLine::Sign::line)
    canvas.line(std::array{Point{middle.x - room / 2, middle.y}, Point{middle.x + room / 2, middle.y}},
                ink::ghost, width * scale);
}

/// Beside the domain where there is room for it, or else in a corner of the domain: not over its walls.
Point corner_for(Point extent, bool right, double margin, const Picture& picture, const PictureView& view) {
  const auto [low, size] = domain(picture, view);
  const Point high{low.x + size.x, low.y + size.y};
  const double left_end = view.scene.corner.x, right_end = left_end + view.scene.extent.x;
  const double needed = extent.x + 2 * margin;
  const double y = std::max(view.scene.corner.y, low.y) + margin;
  const double inside_left = std::max(left_end, low.x), inside_right = std::min(right_end, high.x);
  if (right) {
    const bool inside = right_end - high.x < needed && (inside_right - inside_left) / 2 > needed;
    return {(inside ? inside_right : right_end) - margin - extent.x, y};
  }
  const bool inside = low.x - left_end < needed && inside_right - inside_left > needed;
  return {(inside ? inside_left : left_end) + margin, y};
}

/// In the upper corner of the scene where the chosen particle is, or the left one: the other one is for what
/// is said of that particle.
void paint_key(Canvas& canvas, const Picture& picture, const PictureView& view) {
  const auto lines = key_of(picture);
  if (lines.empty()) return;
  const double scale = view.scale, height = ink::words * scale, leading = 1.35 * height;
  const double margin = 8 * scale, sign = 26 * scale, apart = 8 * scale;
  const double room = view.scene.extent.x - 4 * margin - sign - apart;
  double widest = 0;
  for (const auto& line : lines) {
    const double indent = line.sign == KeyLine::Sign::none ? 0 : sign + apart;
    widest = std::max(widest, indent + std::min(room, canvas.text_width(line.words, height)));
  }
  const Point extent{widest + 2 * margin, static_cast<double>(lines.size()) * leading + margin};
  const bool right = picture.chosen && view.to_pixel(picture.x[picture.chosen->particle], 0).x >=
                                           view.scene.corner.x + view.scene.extent.x / 2;
  const Point corner = corner_for(extent, right, margin, picture, view);
  canvas.rectangle({corner, extent}, behind_words());
  double baseline = corner.y + leading;
  for (const auto& line : lines) {
    const bool bare = line.sign == KeyLine::Sign::none;
    const double x = corner.x + margin;
    if (!bare) paint_sign(canvas, line.sign, {x + sign / 2, baseline - 0.36 * height}, sign, scale);
    ink::fitted_text(canvas, {bare ? x : x + sign + apart, baseline}, line.words, height, room, ink::text);
    baseline += leading;
  }
}

/// Rings, so that the particle below stays visible.
void paint_rings(Canvas& canvas, const Picture& picture, const PictureView& view) {
  const double scale = view.scale;
  const double radius = std::max(picture.radius * view.pixels_per_unit, smallest_ring * scale);
  const Colour inside = ink::translucent(ink::ghost, 0.12F);
  std::vector<Disc> discs;
  for (Eigen::Index i = 0; i < picture.ghosts->x.size(); ++i) {
    const Point at = view.to_pixel(picture.ghosts->x[i], picture.ghosts->y[i]);
    if (!is_number(at)) continue;
    discs.push_back({at, radius, inside});
    discs.push_back({at, radius, ink::ghost, std::max(0.0, radius - width * scale)});
  }
  canvas.discs(discs);
}

void paint_lines(Canvas& canvas, const Ghosts& ghosts, const PictureView& view) {
  std::vector<Point> points;
  const auto draw = [&] {
    if (points.size() > 1) canvas.line(points, ink::ghost, width * view.scale);
    points.clear();
  };
  for (Eigen::Index i = 0; i < ghosts.x.size(); ++i) {
    const Point at = view.to_pixel(ghosts.x[i], ghosts.y[i]);
    if (is_number(at))
      points.push_back(at);
    else
      draw();
  }
  if (ghosts.shape == Shape::outline && !points.empty()) points.push_back(points.front());
  draw();
}

/// Staffs on the places, each a line of text taller than the one before it, with the labels on the right
/// where there is room; the taller ones are those that no label crosses.
void paint_labels(Canvas& canvas, const Picture& picture, const PictureView& view) {
  const Ghosts& ghosts = *picture.ghosts;
  const double scale = view.scale, height = ink::numbers * scale, gap = 6 * scale;
  std::vector<std::pair<Point, std::string>> marks;
  for (Eigen::Index i = 0; i < ghosts.x.size(); ++i) {
    const Point foot = view.to_pixel(ghosts.x[i], ghosts.y[i]);
    const bool inside = ghosts.x[i] >= picture.lower.x() && ghosts.x[i] <= picture.upper.x();
    if (is_number(foot) && inside && view.shows(foot))
      marks.emplace_back(foot, ghosts.labels[static_cast<std::size_t>(i)]);
  }
  if (marks.empty()) return;
  std::ranges::sort(marks, {}, [](const auto& mark) { return mark.first.x; });
  double longest = 0;
  for (const auto& mark : marks) longest = std::max(longest, canvas.text_width(mark.second, height));
  const bool to_the_left = marks.back().first.x + gap + longest > view.scene.corner.x + view.scene.extent.x;
  if (!to_the_left) std::ranges::reverse(marks);
  double staff = mark_height * scale;
  for (const auto& [foot, label] : marks) {
    staff += 1.25 * height;
    const Point head{foot.x, foot.y - staff};
    canvas.line(std::array{foot, head}, ink::ghost, width * scale);
    canvas.discs(std::array{Disc{foot, 4 * scale, ink::ghost}});
    const double room = canvas.text_width(label, height);
    const double x = to_the_left ? head.x - gap - room : head.x + gap;
    canvas.rectangle({{x - gap / 2, head.y - 0.1 * height}, {room + gap, 1.2 * height}}, behind_words());
    canvas.text({x, head.y + 0.8 * height}, label, height, ink::ghost);
  }
}

void paint_measured(Canvas& canvas, const Ghosts& ghosts, const PictureView& view) {
  std::vector<Disc> discs;
  for (Eigen::Index i = 0; i < ghosts.measured_x.size(); ++i) {
    const Point at = view.to_pixel(ghosts.measured_x[i], ghosts.measured_y[i]);
    if (!is_number(at) || !view.shows(at)) continue;
    discs.push_back({at, dot_radius * view.scale, ink::text});
    discs.push_back({at, (dot_radius - 1.2) * view.scale, ink::paper});
  }
  if (!discs.empty()) canvas.discs(discs);
}

}  // namespace

void paint_reference(Canvas& canvas, const Picture& picture, const PictureView& view) {
  if (const auto& ghosts = picture.ghosts) {
    paint_measured(canvas, *ghosts, view);
    if (ghosts->shape == Shape::particles) paint_rings(canvas, picture, view);
    if (ghosts->shape == Shape::marks) paint_labels(canvas, picture, view);
    if (ghosts->shape == Shape::outline || ghosts->shape == Shape::lines) paint_lines(canvas, *ghosts, view);
  }
  paint_key(canvas, picture, view);
}

}  // namespace clapotis
