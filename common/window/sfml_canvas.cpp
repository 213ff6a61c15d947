#include "common/window/sfml_canvas.hpp"

#include <SFML/Graphics/Image.hpp>
#include <SFML/Graphics/Text.hpp>
#include <SFML/Graphics/View.hpp>
#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <numbers>
#include <string>

#include "common/window/fonts.hpp"

namespace clapotis {
namespace {

sf::Color of(Colour c) {
  const auto byte = [](float part) {
    return static_cast<sf::Uint8>(std::lround(255 * std::clamp(part, 0.0f, 1.0f)));
  };
  return {byte(c.red), byte(c.green), byte(c.blue), byte(c.opacity)};
}

sf::Vector2f of(Point p) { return {static_cast<float>(p.x), static_cast<float>(p.y)}; }

sf::String of(std::string_view utf8) { return sf::String::fromUtf8(utf8.begin(), utf8.end()); }

/// One smooth disc in each size 4, 8, ... 256 pixels of radius, below one another: a disc is drawn from the
/// next larger one, shrunk by less than two, so that its edge stays one pixel soft at every size.
constexpr std::array<unsigned, 7> atlas_radii{4, 8, 16, 32, 64, 128, 256};
constexpr unsigned atlas_margin = 2;  ///< transparent pixels around each disc
constexpr unsigned atlas_cell(unsigned radius) { return 2 * (radius + atlas_margin); }

constexpr unsigned atlas_row(std::size_t level) {
  unsigned row = 0;
  for (std::size_t k = 0; k < level; ++k) row += atlas_cell(atlas_radii[k]);
  return row;
}

sf::Image disc_atlas() {
  sf::Image image;
  image.create(atlas_cell(atlas_radii.back()), atlas_row(atlas_radii.size()), sf::Color(255, 255, 255, 0));
  for (std::size_t level = 0; level < atlas_radii.size(); ++level) {
    const double radius = atlas_radii[level];
    const unsigned cell = atlas_cell(atlas_radii[level]);
    for (unsigned y = 0; y < cell; ++y) {
      for (unsigned x = 0; x < cell; ++x) {
        const double distance = std::hypot(x + 0.5 - cell / 2.0, y + 0.5 - cell / 2.0);
        const double covered = std::clamp(radius + 0.5 - distance, 0.0, 1.0);
        image.setPixel(x, atlas_row(level) + y,
                       sf::Color(255, 255, 255, static_cast<sf::Uint8>(std::lround(255 * covered))));
      }
    }
  }
  return image;
}

/// Inside the largest disc everything is white: what is not textured takes its colour from there.
sf::Vector2f white() {
  const auto middle = static_cast<float>(atlas_cell(atlas_radii.back())) / 2;
  return {middle, static_cast<float>(atlas_row(atlas_radii.size() - 1)) + middle};
}

void append_quad(std::vector<sf::Vertex>& vertices, const std::array<sf::Vertex, 4>& quad) {
  for (const std::size_t corner : {0, 1, 2, 0, 2, 3}) vertices.push_back(quad[corner]);
}

unsigned font_pixels(double height) { return static_cast<unsigned>(std::max(1L, std::lround(height))); }

}  // namespace

SfmlCanvas::SfmlCanvas(sf::RenderTarget& target) : target_(target) {
  disc_atlas_.loadFromImage(disc_atlas());
  disc_atlas_.setSmooth(true);
  if (const auto path = find_font("DejaVuSans.ttf")) has_font_ = font_.loadFromFile(path->string());
  if (!has_font_)
    std::fprintf(stderr,
                 "clapotis: no text in the picture without DejaVuSans.ttf (install fonts-dejavu-core)\n");
}

void SfmlCanvas::start(Colour background) {
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
  const std::array<sf::Vertex, 4> strip{sf::Vertex(of(a), colour), sf::Vertex(of(Point{b.x, a.y}), colour),
                                        sf::Vertex(of(Point{a.x, b.y}), colour), sf::Vertex(of(b), colour)};
  target_.draw(strip.data(), strip.size(), sf::TriangleStrip);
}

void SfmlCanvas::discs(std::span<const Disc> discs) {
  vertices_.clear();
  vertices_.reserve(6 * discs.size());
  for (const Disc& disc : discs) {
    if (disc.hole > 0) {
      append_ring(disc);
    } else {
      append_disc(disc);
    }
  }
  draw_vertices();
}

void SfmlCanvas::append_disc(const Disc& disc) {
  const auto larger = std::lower_bound(atlas_radii.begin(), atlas_radii.end() - 1, disc.radius,
                                       [](unsigned size, double radius) { return size < radius; });
  const auto cell = static_cast<float>(atlas_cell(*larger));
  const auto top = static_cast<float>(atlas_row(static_cast<std::size_t>(larger - atlas_radii.begin())));
  const auto reach = static_cast<float>(disc.radius * (*larger + atlas_margin) / *larger);
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

/// A band of full colour with a faded rim of one pixel on each side; neighbouring segments share their
/// corners on the bisector of the angle between them, whose length is bounded at sharp turns. The first
/// `hidden` segments only prepare the joint of the next one.
void SfmlCanvas::append_band(std::span<const Point> points, Colour colour, double width, std::size_t hidden) {
  if (points.size() < 2) return;
  const auto normal = [](Point from, Point to) -> Point {
    const double dx = to.x - from.x, dy = to.y - from.y, length = std::hypot(dx, dy);
    return length > 0 ? Point{-dy / length, dx / length} : Point{0, 0};
  };
  const double drawn = std::max(width, 1.0);  // thinner than a pixel: one pixel wide, but paler
  colour.opacity *= static_cast<float>(width / drawn);
  const auto solid = of(colour);
  const auto faded = sf::Color(solid.r, solid.g, solid.b, 0);
  const std::array<sf::Color, 4> shades{faded, solid, solid, faded};
  const double inner = (drawn - 1) / 2, outer = (drawn + 1) / 2;
  const std::array<double, 4> offsets{-outer, -inner, inner, outer};
  std::array<sf::Vertex, 4> last{}, next{};
  Point before{0, 0};
  for (std::size_t i = 0; i < points.size(); ++i) {
    Point after = i + 1 < points.size() ? normal(points[i], points[i + 1]) : before;
    if (after == Point{0, 0}) after = before;  // two points in one place
    if (before == Point{0, 0}) before = after;
    const Point sum{before.x + after.x, before.y + after.y};
    const double squared =
        std::max(sum.x * sum.x + sum.y * sum.y, 0.5);  // the longest mitre: 2.8 half widths
    for (std::size_t edge = 0; edge < 4; ++edge) {
      const double reach = 2 * offsets[edge] / squared;
      next[edge] = sf::Vertex(of(Point{points[i].x + reach * sum.x, points[i].y + reach * sum.y}),
                              shades[edge], white());
    }
    for (std::size_t edge = 0; i > hidden && edge < 3; ++edge) {
      append_quad(vertices_, {last[edge], next[edge], next[edge + 1], last[edge + 1]});
    }
    last = next;
    before = after;
  }
}

void SfmlCanvas::line(std::span<const Point> points, Colour colour, double width) {
  vertices_.clear();
  append_band(points, colour, width, 0);
  draw_vertices();
}

void SfmlCanvas::segments(std::span<const Point> ends, Colour colour, double width) {
  vertices_.clear();
  for (std::size_t k = 0; k + 1 < ends.size(); k += 2) append_band(ends.subspan(k, 2), colour, width, 0);
  draw_vertices();
}

void SfmlCanvas::draw_vertices() {
  if (!vertices_.empty()) target_.draw(vertices_.data(), vertices_.size(), sf::Triangles, &disc_atlas_);
}

void SfmlCanvas::text(Point at, std::string_view utf8, double height, Colour colour, Align align) {
  if (!has_font_) return;
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
  const auto whole = size();
  target_.setView(sf::View(sf::FloatRect({0, 0}, of(whole))));
}

}  // namespace clapotis
