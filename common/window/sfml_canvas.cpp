#include "common/window/sfml_canvas.hpp"

#include <SFML/Graphics/Image.hpp>
#include <SFML/Graphics/Text.hpp>
#include <SFML/Graphics/View.hpp>
#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
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
    const auto larger = std::lower_bound(atlas_radii.begin(), atlas_radii.end() - 1, disc.radius,
                                         [](unsigned size, double radius) { return size < radius; });
    const auto level = static_cast<std::size_t>(larger - atlas_radii.begin());
    const auto cell = static_cast<float>(atlas_cell(*larger));
    const auto top = static_cast<float>(atlas_row(level));
    const auto reach = static_cast<float>(disc.radius * (*larger + atlas_margin) / *larger);
    const auto colour = of(disc.colour);
    const auto centre = of(disc.centre);
    append_quad(vertices_, {sf::Vertex({centre.x - reach, centre.y - reach}, colour, {0, top}),
                            sf::Vertex({centre.x + reach, centre.y - reach}, colour, {cell, top}),
                            sf::Vertex({centre.x + reach, centre.y + reach}, colour, {cell, top + cell}),
                            sf::Vertex({centre.x - reach, centre.y + reach}, colour, {0, top + cell})});
  }
  if (!vertices_.empty()) target_.draw(vertices_.data(), vertices_.size(), sf::Triangles, &disc_atlas_);
}

/// A band of full colour with a faded rim of one pixel on each side; neighbouring segments share their
/// corners on the bisector of the angle between them, whose length is bounded at sharp turns.
void SfmlCanvas::line(std::span<const Point> points, Colour colour, double width) {
  if (points.size() < 2) return;
  const auto normal = [](Point from, Point to) -> Point {
    const double dx = to.x - from.x, dy = to.y - from.y, length = std::hypot(dx, dy);
    return length > 0 ? Point{-dy / length, dx / length} : Point{0, 0};
  };
  // Thinner than a pixel: one pixel wide, but paler.
  const double drawn = std::max(width, 1.0);
  auto full = colour;
  full.opacity *= static_cast<float>(width / drawn);
  const double inner = (drawn - 1) / 2, outer = (drawn + 1) / 2;
  corners_.clear();
  Point before{0, 0};
  for (std::size_t i = 0; i < points.size(); ++i) {
    const Point after = i + 1 < points.size() ? normal(points[i], points[i + 1]) : before;
    const Point first = i == 0 || before == Point{0, 0} ? after : before;
    const Point sum{first.x + after.x, first.y + after.y};
    const double squared = std::max(sum.x * sum.x + sum.y * sum.y, 0.5);  // longest mitre: 2.8 half widths
    const Point mitre{2 * sum.x / squared, 2 * sum.y / squared};
    for (const double offset : {-outer, -inner, inner, outer}) {
      corners_.push_back({points[i].x + offset * mitre.x, points[i].y + offset * mitre.y});
    }
    before = after == Point{0, 0} ? before : after;
  }
  const auto solid = of(full);
  const auto faded = of(Colour{colour.red, colour.green, colour.blue, 0});
  const std::array<sf::Color, 4> shades{faded, solid, solid, faded};
  vertices_.clear();
  for (std::size_t i = 0; i + 1 < points.size(); ++i) {
    for (std::size_t edge = 0; edge < 3; ++edge) {
      const std::size_t a = 4 * i + edge, b = a + 4;
      append_quad(vertices_,
                  {sf::Vertex(of(corners_[a]), shades[edge]), sf::Vertex(of(corners_[b]), shades[edge]),
                   sf::Vertex(of(corners_[b + 1]), shades[edge + 1]),
                   sf::Vertex(of(corners_[a + 1]), shades[edge + 1])});
    }
  }
  target_.draw(vertices_.data(), vertices_.size(), sf::Triangles);
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
