#include "common/runner/picture.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <stdexcept>

#include "common/runner/ink.hpp"
#include "common/runner/legend.hpp"
#include "common/runner/reference_marks.hpp"

namespace clapotis {
namespace {

constexpr double wall_thickness = 6;
constexpr double smallest_disc = 1.25;  ///< radius below which a particle would fade away [pixel]
constexpr double smallest_mark = 5;     ///< radius of the ring around a marked particle [pixel]
constexpr double smallest_rimmed = 5;   ///< radius from which discs have a rim [pixel]
constexpr double wet_growth = 1.45;     ///< of a liquid's particles too small for a rim, to close the gaps
constexpr double smallest_cell = 4;     ///< side below which the lines of the cells would be one grey [pixel]

void require_matching_sizes(const Picture& picture) {
  const auto n = picture.x.size();
  const auto demand = [](bool holds, const char* sentence) {
    if (!holds) throw std::invalid_argument(sentence);
  };
  const auto exists = [n](Eigen::Index i) { return i >= 0 && i < n; };
  demand(picture.y.size() == n, "a picture's y needs as many entries as its x");
  demand(picture.value.size() == 0 || picture.value.size() == n,
         "a picture's value needs as many entries as its x, or none");
  demand(!picture.ghosts || (picture.ghosts->x.size() == picture.ghosts->y.size() &&
                             picture.ghosts->measured_x.size() == picture.ghosts->measured_y.size()),
         "a picture's ghosts need as many y as x");
  demand(!picture.ghosts || picture.ghosts->shape != Shape::marks ||
             std::ssize(picture.ghosts->labels) == picture.ghosts->x.size(),
         "a picture's marks need as many labels as points");
  demand(!picture.chosen || exists(picture.chosen->particle), "a picture's chosen particle does not exist");
  demand(!picture.chosen || std::ranges::all_of(picture.chosen->neighbours, exists),
         "a neighbour of a picture's chosen particle does not exist");
}

Box domain(const Picture& picture, const PictureView& view) {
  const Point upper_left = view.to_pixel(picture.lower.x(), picture.upper.y());
  const Eigen::Array2d extent = (picture.upper - picture.lower) * view.pixels_per_unit;
  return {upper_left, {extent.x(), extent.y()}};
}

bool is_seen(const Disc& disc, const Box& box) {  // false for NaN, too
  return disc.centre.x + disc.radius > box.corner.x && disc.centre.y + disc.radius > box.corner.y &&
         disc.centre.x - disc.radius < box.corner.x + box.extent.x &&
         disc.centre.y - disc.radius < box.corner.y + box.extent.y;
}

Colour darker(Colour c) { return {0.62F * c.red, 0.62F * c.green, 0.62F * c.blue, c.opacity}; }

Colour translucent(Colour c, float opacity) { return {c.red, c.green, c.blue, opacity}; }

/// Where the domain ends, solid or not.
void paint_rim(Canvas& canvas, const Box& inside, double width) {
  const Point corner = inside.corner, opposite{corner.x + inside.extent.x, corner.y + inside.extent.y};
  canvas.line(std::array{corner, Point{opposite.x, corner.y}, opposite, Point{corner.x, opposite.y}, corner},
              ink::grid, width);
}

/// Walls stand outside the domain, so that a particle touches the wall where the simulation says so.
void paint_walls(Canvas& canvas, const SolidSides& walls, const Box& inside, double thickness) {
  const double x = inside.corner.x, y = inside.corner.y;
  const double width = inside.extent.x, height = inside.extent.y;
  const auto reach = [thickness](bool solid) { return solid ? thickness : 0; };  // walls that meet overlap
  const double left = reach(walls.left), right = reach(walls.right);
  const double above = reach(walls.top), below = reach(walls.bottom);
  const auto upright = [&](double at) {
    canvas.rectangle({{at, y - above}, {thickness, height + above + below}}, ink::wall);
  };
  const auto level = [&](double at) {
    canvas.rectangle({{x - left, at}, {width + left + right, thickness}}, ink::wall);
  };
  if (walls.left) upright(x - thickness);
  if (walls.right) upright(x + width);
  if (walls.bottom) level(y + height);
  if (walls.top) level(y - thickness);
}

}  // namespace

Point PictureView::to_pixel(double x, double y) const {
  return {scene.corner.x + scene.extent.x / 2 + (x - centre.x()) * pixels_per_unit,
          scene.corner.y + scene.extent.y / 2 - (y - centre.y()) * pixels_per_unit};
}

bool PictureView::shows(Point pixel) const {
  return pixel.x >= scene.corner.x && pixel.x < scene.corner.x + scene.extent.x &&
         pixel.y >= scene.corner.y && pixel.y < scene.corner.y + scene.extent.y;
}

Eigen::Vector2d PictureView::to_world(Point pixel) const {
  return {centre.x() + (pixel.x - scene.corner.x - scene.extent.x / 2) / pixels_per_unit,
          centre.y() - (pixel.y - scene.corner.y - scene.extent.y / 2) / pixels_per_unit};
}

PictureView fit(const Picture& picture, const Box& area, double scale) {
  const double header = header_height(area.extent.x, scale, picture.value.size() > 0);
  const double height = std::max(1.0, area.extent.y - header - footer_height(scale));
  const Box scene{{area.corner.x, area.corner.y + header}, {area.extent.x, height}};
  const Eigen::Array2d world = (picture.upper - picture.lower).max(1e-300);
  const double side = ink::margin * scale,
               above = wall_thickness * scale;  // the walls are outside the domain
  const Eigen::Array2d room = Eigen::Array2d(area.extent.x - 2 * side, height - 2 * above).max(1.0);
  return {area, scene, scale, (picture.lower + picture.upper).matrix() / 2, (room / world).minCoeff()};
}

void Painter::paint(Canvas& canvas, const Picture& picture, const PictureView& view) {
  require_matching_sizes(picture);
  canvas.rectangle(view.area, ink::sheet);
  canvas.clip(view.scene);
  paint_scene(canvas, picture, view);
  canvas.unclip();
  paint_header(canvas, picture, view);
  paint_footer(canvas, picture, view);
}

void Painter::paint_scene(Canvas& canvas, const Picture& picture, const PictureView& view) {
  const Box inside = domain(picture, view);
  canvas.rectangle(inside, ink::paper);
  paint_cells(canvas, picture, view);
  paint_rim(canvas, inside, wall_thickness / 4 * view.scale);
  const auto walls = [&] { paint_walls(canvas, picture.walls, inside, wall_thickness * view.scale); };
  if (!picture.liquid) walls();
  paint_particles(canvas, picture, view);
  paint_solids(canvas, picture, view);
  if (picture.liquid) walls();  // they cut off straight what closes the gaps of the liquid
  paint_marks(canvas, picture, view);
  paint_reference(canvas, picture, view);
}

/// The cells of the neighbour search; those in which the chosen particle's neighbours are looked for are
/// tinted.
void Painter::paint_cells(Canvas& canvas, const Picture& picture, const PictureView& view) {
  if (!picture.cell || !(*picture.cell * view.pixels_per_unit >= smallest_cell)) return;
  const double cell = *picture.cell;
  const Eigen::Array2d lower = picture.lower, upper = picture.upper;
  if (picture.chosen) {
    const auto i = picture.chosen->particle;
    const Eigen::Array2d own = ((Eigen::Array2d(picture.x[i], picture.y[i]) - lower) / cell).floor();
    const Eigen::Array2d from = (lower + (own - 1) * cell).max(lower),
                         to = (lower + (own + 2) * cell).min(upper);
    const Point corner = view.to_pixel(from.x(), to.y());
    const Eigen::Array2d extent = (to - from) * view.pixels_per_unit;
    if ((extent > 0).all())
      canvas.rectangle({corner, {extent.x(), extent.y()}}, translucent(ink::chosen, 0.22F));
  }
  points_.clear();
  for (int k = 1; lower.x() + k * cell < upper.x(); ++k) {
    points_.push_back(view.to_pixel(lower.x() + k * cell, lower.y()));
    points_.push_back(view.to_pixel(lower.x() + k * cell, upper.y()));
  }
  for (int k = 1; lower.y() + k * cell < upper.y(); ++k) {
    points_.push_back(view.to_pixel(lower.x(), lower.y() + k * cell));
    points_.push_back(view.to_pixel(upper.x(), lower.y() + k * cell));
  }
  canvas.segments(points_, ink::grid, view.scale);
}

void Painter::paint_particles(Canvas& canvas, const Picture& picture, const PictureView& view) {
  const double own = picture.radius * view.pixels_per_unit;
  const bool rimmed = own >= smallest_rimmed * view.scale, wet = picture.liquid && !rimmed;
  const double radius = std::max(wet ? wet_growth * own : own, smallest_disc * view.scale);
  const double rim = rimmed ? std::clamp(0.12 * radius, 1.0, 3 * view.scale) : 0;
  const auto& colours = picture.colours;
  const bool flat = !(colours.hi > colours.lo);  // then all have the colour in the middle of the map
  const double lo = flat ? colours.lo - 0.5 : colours.lo, range = flat ? 1 : colours.hi - colours.lo;
  discs_.clear();
  for (Eigen::Index i = 0; i < picture.x.size(); ++i) {
    const Colour colour =
        picture.value.size() == 0 ? ink::plain_disc : at(colours.map, (picture.value[i] - lo) / range);
    const Disc disc{view.to_pixel(picture.x[i], picture.y[i]), radius, colour};
    if (!is_seen(disc, view.scene)) continue;
    if (rim > 0) discs_.push_back({disc.centre, radius, darker(colour)});
    discs_.push_back({disc.centre, radius - rim, colour});
  }
  canvas.discs(discs_);
}

/// Without gaps: they are one body.
void Painter::paint_solids(Canvas& canvas, const Picture& picture, const PictureView& view) {
  discs_.clear();
  const double radius =
      std::max(wet_growth * picture.radius * view.pixels_per_unit, smallest_disc * view.scale);
  for (Eigen::Index i = 0; i < picture.solid_x.size(); ++i) {
    const Disc disc{view.to_pixel(picture.solid_x[i], picture.solid_y[i]), radius, ink::wall};
    if (is_seen(disc, view.scene)) discs_.push_back(disc);
  }
  if (!discs_.empty()) canvas.discs(discs_);
}

/// Neighbours and the chosen particle: rings, so that the particle below stays visible.
void Painter::paint_marks(Canvas& canvas, const Picture& picture, const PictureView& view) {
  const double scale = view.scale, disc = picture.radius * view.pixels_per_unit;
  const double radius = std::max(disc, smallest_mark * scale);
  const auto ring = [&](Point centre, double outer, double width, Colour colour) {
    const Disc mark{centre, outer, colour, std::max(0.0, outer - width)};
    if (is_seen(mark, view.scene)) discs_.push_back(mark);
  };
  discs_.clear();
  if (picture.chosen) {
    const auto where = [&](Eigen::Index i) { return view.to_pixel(picture.x[i], picture.y[i]); };
    const auto self = picture.chosen->particle;
    for (const auto i : picture.chosen->neighbours) {
      ring(where(i), radius + scale, std::max(2.5 * scale, 0.3 * radius), ink::chosen);
    }
    ring(where(self), radius + 3 * scale, 4 * scale, ink::paper);
    ring(where(self), radius + 3 * scale + 2, std::max(3 * scale, 0.3 * radius), ink::text);
    points_.clear();
    for (int k = 0; k <= 128; ++k) {
      const double angle = 2 * std::numbers::pi * k / 128,
                   reach = picture.chosen->support * view.pixels_per_unit;
      const Point centre = where(self);
      points_.push_back({centre.x + reach * std::cos(angle), centre.y + reach * std::sin(angle)});
    }
    canvas.line(points_, ink::chosen, 3 * scale);
  }
  canvas.discs(discs_);
}

}  // namespace clapotis
