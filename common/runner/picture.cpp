#include "common/runner/picture.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <stdexcept>

#include "common/runner/ink.hpp"
#include "common/runner/legend.hpp"
#include "common/runner/paint_inside.hpp"
#include "common/runner/reference_marks.hpp"

namespace clapotis {
namespace {

constexpr double wall_thickness = 6;
constexpr double smallest_disc = 1.25;  ///< radius below which a particle would fade away [pixel]
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
  demand(!picture.chosen || std::ranges::all_of(picture.chosen->in_vain, exists),
         "a candidate of a picture's chosen particle does not exist");
}

bool is_seen(const Disc& disc, const Box& box) {  // false for NaN, too
  return disc.centre.x + disc.radius > box.corner.x && disc.centre.y + disc.radius > box.corner.y &&
         disc.centre.x - disc.radius < box.corner.x + box.extent.x &&
         disc.centre.y - disc.radius < box.corner.y + box.extent.y;
}

Colour darker(Colour c) { return {0.62F * c.red, 0.62F * c.green, 0.62F * c.blue, c.opacity}; }

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

Box domain(const Picture& picture, const PictureView& view) {
  const Point upper_left = view.to_pixel(picture.lower.x(), picture.upper.y());
  const Eigen::Array2d extent = (picture.upper - picture.lower) * view.pixels_per_unit;
  return {upper_left, {extent.x(), extent.y()}};
}

PictureView fit(const Picture& picture, const Box& area, double scale) {
  const double header = header_height(area.extent.x, scale, has_legend(picture));
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
  paint_visited_cells(canvas, picture, view);
  paint_cells(canvas, picture, view);
  paint_rim(canvas, inside, wall_thickness / 4 * view.scale);
  const auto walls = [&] { paint_walls(canvas, picture.walls, inside, wall_thickness * view.scale); };
  if (!picture.liquid) walls();
  paint_particles(canvas, picture, view);
  paint_solids(canvas, picture, view);
  if (picture.liquid) walls();  // they cut off straight what closes the gaps of the liquid
  paint_marks(canvas, picture, view);
  paint_reference(canvas, picture, view);
  paint_forces(canvas, picture, view);
  paint_facts(canvas, picture, view);
  paint_alarm(canvas, picture, view);
}

/// The cells of the neighbour search.
void Painter::paint_cells(Canvas& canvas, const Picture& picture, const PictureView& view) {
  if (!picture.cell || !(*picture.cell * view.pixels_per_unit >= smallest_cell)) return;
  const double cell = *picture.cell;
  const Eigen::Array2d lower = picture.lower, upper = picture.upper;
  points_.clear();
  for (double k = std::floor(lower.x() / cell) + 1; k * cell < upper.x(); ++k) {
    points_.push_back(view.to_pixel(k * cell, lower.y()));
    points_.push_back(view.to_pixel(k * cell, upper.y()));
  }
  for (double k = std::floor(lower.y() / cell) + 1; k * cell < upper.y(); ++k) {
    points_.push_back(view.to_pixel(lower.x(), k * cell));
    points_.push_back(view.to_pixel(upper.x(), k * cell));
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

/// A box in the upper part of the scene: what is shown below it is the last good state.
void Painter::paint_alarm(Canvas& canvas, const Picture& picture, const PictureView& view) {
  if (picture.alarm.empty()) return;
  const double scale = view.scale, height = ink::words * scale, leading = 1.35 * height, pad = 14 * scale,
               rim = 2 * scale;
  const double width = std::min(view.scene.extent.x - 2 * ink::margin * scale, 640 * scale);
  const auto lines = ink::broken(canvas, picture.alarm, height, width - 2 * pad);
  const Point corner{view.scene.corner.x + (view.scene.extent.x - width) / 2,
                     view.scene.corner.y + ink::margin * scale};
  const double tall = leading * static_cast<double>(lines.size()) + 2 * pad;
  ink::paper_box(canvas, {corner, {width, tall}}, ink::warning, rim);
  double baseline = corner.y + pad + height;
  for (const auto& line : lines) {
    canvas.text({corner.x + pad, baseline}, line, height, ink::warning);
    baseline += leading;
  }
}

/// Who is near the chosen particle: rings, so that the particles below stay visible.
void Painter::paint_marks(Canvas& canvas, const Picture& picture, const PictureView& view) {
  discs_.clear();
  add_chosen_rings(picture, view, discs_);
  canvas.discs(discs_);
  paint_support(canvas, picture, view);
}

}  // namespace clapotis
