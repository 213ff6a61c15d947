#include "common/window/sfml_canvas.hpp"

#include <SFML/Graphics/Image.hpp>
#include <SFML/Graphics/Text.hpp>
#include <SFML/Graphics/View.hpp>
#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <string>

#include "common/runner/exit_code.hpp"
#include "common/window/fonts.hpp"
#include "common/words.hpp"

namespace clapotis {
namespace {

sf::Color of(Colour c) {
  const auto byte = [](float part) {
    const float nearest =
        255 * std::clamp(part, 0.0f, 1.0f) + 0.5f;  // never negative: cutting it off rounds it
    return static_cast<sf::Uint8>(nearest);
  };
  return {byte(c.red), byte(c.green), byte(c.blue), byte(c.opacity)};
}

sf::Vector2f of(Point p) { return {static_cast<float>(p.x), static_cast<float>(p.y)}; }

/// SFML 2 paints two white pixels for any blank letter but the plain space: no-break and narrow spaces become
/// one.
sf::String of(std::string_view utf8) {
  auto string = sf::String::fromUtf8(utf8.begin(), utf8.end());
  for (const sf::Uint32 blank : {0xA0U, 0x2009U, 0x202FU}) string.replace(blank, U' ');
  return string;
}

// The one texture: white, with all shapes in its opacity.
// Discs of radius 1, 2, 4, ... 256 pixels, below one another: a disc is drawn from the next larger one,
// shrunk by less than two, so that its edge stays one pixel soft at every size. Beside the first discs, the
// cross sections of lines.

constexpr std::array<unsigned, 9> atlas_radii{1, 2, 4, 8, 16, 32, 64, 128, 256};
constexpr unsigned atlas_margin = 2;  ///< transparent pixels around each disc
constexpr unsigned atlas_cell(unsigned radius) { return 2 * (radius + atlas_margin); }

constexpr unsigned atlas_row(std::size_t level) {
  unsigned row = 0;
  for (std::size_t k = 0; k < level; ++k) row += atlas_cell(atlas_radii[k]);
  return row;
}

/// The smallest disc that is not smaller.
std::size_t atlas_level(double radius) {
  const auto larger = std::lower_bound(atlas_radii.begin(), atlas_radii.end() - 1, radius,
                                       [](unsigned size, double wanted) { return size < wanted; });
  return static_cast<std::size_t>(larger - atlas_radii.begin());
}

constexpr double thinnest = 1, thickest = 8;  // lines with a cross section of their own [pixel]
constexpr double sections_per_pixel = 4;
constexpr unsigned sections_left = 48, section_width = 4;  // of the texture: the first one, and the next ones
constexpr double texels_per_pixel = 4;  // across a line: its edge is not linear within a pixel
constexpr unsigned section_rows = 48;
constexpr double section_middle = section_rows / 2.0;
static_assert((thickest + 1) * texels_per_pixel < section_rows);

/// Opacity at `distance` from the middle of a shape that reaches to `radius`: its edge is one pixel soft.
sf::Color covered(double radius, double distance) {
  return {255, 255, 255,
          static_cast<sf::Uint8>(std::lround(255 * std::clamp(radius + 0.5 - distance, 0.0, 1.0)))};
}

sf::Image make_atlas() {
  sf::Image image;
  image.create(atlas_cell(atlas_radii.back()), atlas_row(atlas_radii.size()), sf::Color(255, 255, 255, 0));
  for (std::size_t level = 0; level < atlas_radii.size(); ++level) {
    const unsigned cell = atlas_cell(atlas_radii[level]);
    for (unsigned y = 0; y < cell; ++y) {
      for (unsigned x = 0; x < cell; ++x) {
        const double distance = std::hypot(x + 0.5 - cell / 2.0, y + 0.5 - cell / 2.0);
        image.setPixel(x, atlas_row(level) + y, covered(atlas_radii[level], distance));
      }
    }
  }
  for (unsigned k = 0; thinnest + k / sections_per_pixel <= thickest; ++k) {
    for (unsigned x = 0; x < section_width; ++x) {
      for (unsigned y = 0; y < section_rows; ++y) {
        image.setPixel(sections_left + section_width * k + x, y,
                       covered((thinnest + k / sections_per_pixel) / 2,
                               std::abs(y + 0.5 - section_middle) / texels_per_pixel));
      }
    }
  }
  return image;
}

struct CrossSection {
  sf::Vector2f left, right;  ///< of the texture [pixel]
  double reach;              ///< from the middle of the line to where it has faded [pixel]
};

CrossSection cross_section(double width) {
  if (width <= thickest) {
    const auto k = static_cast<float>(std::lround(sections_per_pixel * (width - thinnest)));
    const float x = static_cast<float>(sections_left) + static_cast<float>(section_width) * (k + 0.5f);
    const double reach = (width + 1) / 2, rows = texels_per_pixel * reach;
    return {{x, static_cast<float>(section_middle - rows)},
            {x, static_cast<float>(section_middle + rows)},
            reach};
  }
  const auto level = atlas_level(width / 2);  // that of a disc
  const auto cell = static_cast<float>(atlas_cell(atlas_radii[level])),
             top = static_cast<float>(atlas_row(level));
  return {{cell / 2, top},
          {cell / 2, top + cell},
          width / 2 * (atlas_radii[level] + atlas_margin) / atlas_radii[level]};
}

/// Inside the largest disc everything is white: what is not textured takes its colour from there.
sf::Vector2f white() {
  const auto middle = static_cast<float>(atlas_cell(atlas_radii.back())) / 2;
  return {middle, static_cast<float>(atlas_row(atlas_radii.size() - 1)) + middle};
}

void append_quad(std::vector<sf::Vertex>& vertices, const std::array<sf::Vertex, 4>& quad) {
  vertices.insert(vertices.end(), quad.begin(), quad.end());
}

unsigned font_pixels(double height) { return static_cast<unsigned>(std::max(1L, std::lround(height))); }

}  // namespace

SfmlCanvas::SfmlCanvas(sf::RenderTarget& target) : target_(target) {
  atlas_.loadFromImage(make_atlas());
  atlas_.setSmooth(true);
  if (const auto path = find_font("DejaVuSans.ttf")) has_font_ = font_.loadFromFile(path->string());
  if (!has_font_) complain("clapotis", words().no_letters);
}

void SfmlCanvas::start(Colour background) {
  vertices_.clear();
  unclip();
  target_.clear(of(background));
}

Point SfmlCanvas::size() const {
  const auto size = target_.getSize();
  return {static_cast<double>(size.x), static_cast<double>(size.y)};
}

void SfmlCanvas::rectangle(const Box& box, Colour fill) {
  const auto colour = of(fill);
  const Point a = box.corner, b{a.x + box.extent.x, a.y + box.extent.y};
  append_quad(vertices_,
              {sf::Vertex(of(a), colour, white()), sf::Vertex(of(Point{b.x, a.y}), colour, white()),
               sf::Vertex(of(b), colour, white()), sf::Vertex(of(Point{a.x, b.y}), colour, white())});
}

void SfmlCanvas::discs(std::span<const Disc> discs) {
  vertices_.reserve(vertices_.size() + 4 * discs.size());
  for (const Disc& disc : discs) {
    if (disc.hole > 0) {
      append_ring(disc);
    } else {
      append_disc(disc);
    }
  }
}

void SfmlCanvas::append_disc(const Disc& disc) {
  const auto level = atlas_level(disc.radius);
  const unsigned radius = atlas_radii[level];
  const auto cell = static_cast<float>(atlas_cell(radius)), top = static_cast<float>(atlas_row(level));
  const auto reach = static_cast<float>(disc.radius * (radius + atlas_margin) / radius);
  const auto colour = of(disc.colour);
  const auto centre = of(disc.centre);
  append_quad(vertices_, {sf::Vertex({centre.x - reach, centre.y - reach}, colour, {0, top}),
                          sf::Vertex({centre.x + reach, centre.y - reach}, colour, {cell, top}),
                          sf::Vertex({centre.x + reach, centre.y + reach}, colour, {cell, top + cell}),
                          sf::Vertex({centre.x - reach, centre.y + reach}, colour, {0, top + cell})});
}

void SfmlCanvas::append_ring(const Disc& disc) {
  const double middle = (disc.radius + disc.hole) / 2;
  const int sides = std::clamp(static_cast<int>(4 * std::sqrt(disc.radius)), 12, 180);
  const double angle = 2 * std::numbers::pi / sides;
  ring_.clear();
  for (int k = 0; k <= sides + 1; ++k) {  // one side twice, so that first and last joint are mitred too
    ring_.push_back(
        {disc.centre.x + middle * std::cos(k * angle), disc.centre.y + middle * std::sin(k * angle)});
  }
  append_band(ring_, disc.colour, disc.radius - disc.hole, 1);
}

/// One quad per segment, across which the texture fades at both edges. Where the line bends a little,
/// neighbouring segments share their corners on the bisector of the angle between them; where it bends more,
/// a disc joins them. The first `hidden` segments only prepare the joint of the next one.
void SfmlCanvas::append_band(std::span<const Point> points, Colour colour, double width, std::size_t hidden) {
  if (points.size() < 2) return;
  const auto normal = [](Point from, Point to) -> Point {
    const double dx = to.x - from.x, dy = to.y - from.y, length = std::hypot(dx, dy);
    return length > 0 ? Point{-dy / length, dx / length} : Point{0, 0};
  };
  const double drawn = std::max(width, thinnest);  // thinner than a pixel: one pixel wide, but paler
  colour.opacity *= static_cast<float>(width / drawn);
  const auto shade = of(colour);
  const auto section = cross_section(drawn);
  const auto edge = [&](Point at, Point across, double reach, sf::Vector2f texture) {
    return sf::Vertex(of(Point{at.x + reach * across.x, at.y + reach * across.y}), shade, texture);
  };
  sf::Vertex last_left, last_right;
  Point before{0, 0};
  for (std::size_t i = 0; i < points.size(); ++i) {
    Point after = i + 1 < points.size() ? normal(points[i], points[i + 1]) : before;
    if (after == Point{0, 0}) after = before;  // two points in one place
    if (before == Point{0, 0}) before = after;
    const bool bends = before.x * after.x + before.y * after.y < 0.8;  // by more than 37 degrees
    const Point sum{before.x + after.x, before.y + after.y};
    const double squared = sum.x * sum.x + sum.y * sum.y;
    const Point across = bends || squared == 0 ? before : Point{2 * sum.x / squared, 2 * sum.y / squared};
    const auto left = edge(points[i], across, -section.reach, section.left);
    const auto right = edge(points[i], across, section.reach, section.right);
    if (i > hidden) append_quad(vertices_, {last_left, left, right, last_right});
    last_left = bends ? edge(points[i], after, -section.reach, section.left) : left;
    last_right = bends ? edge(points[i], after, section.reach, section.right) : right;
    if (bends) append_disc({points[i], drawn / 2, colour});
    before = after;
  }
}

void SfmlCanvas::line(std::span<const Point> points, Colour colour, double width) {
  append_band(points, colour, width, 0);
}

/// A piece shorter than that would fall between the pixels: a dashed line of a noisy curve has such pieces.
void SfmlCanvas::segments(std::span<const Point> ends, Colour colour, double width) {
  constexpr double shortest = 1.5;  // [pixel]
  for (std::size_t k = 0; k + 1 < ends.size(); k += 2) {
    Point a = ends[k], b = ends[k + 1];
    const double dx = b.x - a.x, dy = b.y - a.y, length = std::hypot(dx, dy);
    if (length > 0 && length < shortest) {
      const double more = (shortest / length - 1) / 2;
      a = {a.x - more * dx, a.y - more * dy};
      b = {b.x + more * dx, b.y + more * dy};
    }
    append_band(std::array{a, b}, colour, width, 0);
  }
}

void SfmlCanvas::flush() {
  if (!vertices_.empty()) target_.draw(vertices_.data(), vertices_.size(), sf::Quads, &atlas_);
  vertices_.clear();
}

void SfmlCanvas::text(Point at, std::string_view utf8, double height, Colour colour, Align align) {
  if (!has_font_) return;
  flush();
  const unsigned pixels = font_pixels(height);
  const double share = align == Align::left ? 0 : align == Align::centre ? 0.5 : 1;
  sf::Text text(of(utf8), font_, pixels);
  text.setFillColor(of(colour));
  // SFML's own baseline lies one font size below the top; whole pixels keep the letters sharp.
  text.setPosition(static_cast<float>(std::round(at.x - share * text_width(utf8, height))),
                   static_cast<float>(std::round(at.y) - pixels));
  target_.draw(text);
}

double SfmlCanvas::text_width(std::string_view utf8, double height) const {
  if (!has_font_) return 0;
  const auto string = of(utf8);
  const sf::Text text(string, font_, font_pixels(height));
  return static_cast<double>(text.findCharacterPos(string.getSize()).x);
}

void SfmlCanvas::clip(const Box& box) {
  flush();
  const auto whole = size();
  if (whole.x < 1 || whole.y < 1) return;
  const auto left = std::clamp(std::round(box.corner.x), 0.0, whole.x);
  const auto top = std::clamp(std::round(box.corner.y), 0.0, whole.y);
  const auto right = std::clamp(std::round(box.corner.x + box.extent.x), left, whole.x);
  const auto bottom = std::clamp(std::round(box.corner.y + box.extent.y), top, whole.y);
  const auto rectangle = [](double x, double y, double width, double height) {
    return sf::FloatRect({static_cast<float>(x), static_cast<float>(y)},
                         {static_cast<float>(width), static_cast<float>(height)});
  };
  // What lies outside a view's viewport is cut off by OpenGL; coordinates stay those of the whole window.
  sf::View view(rectangle(left, top, right - left, bottom - top));
  view.setViewport(
      rectangle(left / whole.x, top / whole.y, (right - left) / whole.x, (bottom - top) / whole.y));
  target_.setView(view);
}

void SfmlCanvas::unclip() {
  flush();
  const auto whole = size();
  target_.setView(sf::View(sf::FloatRect({0, 0}, of(whole))));
}

}  // namespace clapotis
