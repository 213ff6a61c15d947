#pragma once

#include <SFML/Graphics/Font.hpp>
#include <SFML/Graphics/RenderTarget.hpp>
#include <SFML/Graphics/Texture.hpp>
#include <SFML/Graphics/Vertex.hpp>
#include <vector>

#include "common/runner/canvas.hpp"

namespace clapotis {

/// A Canvas on an SFML window. Discs are textured quads, edges of lines fade out over one pixel: smooth
/// without multisampling, which a lecture laptop without a graphics card could not afford. Buffers are kept
/// between frames.
class SfmlCanvas final : public Canvas {
 public:
  explicit SfmlCanvas(sf::RenderTarget& target);

  /// Forgets the last picture and takes over the target's present size.
  void start(Colour background);
  /// Hands over what waits. Everything but text is triangles of one texture: what comes between two texts or
  /// clips is one draw call, all discs of a picture among them.
  void flush();

  [[nodiscard]] Point size() const override;
  void rectangle(const Box& box, Colour fill) override;
  void discs(std::span<const Disc> discs) override;
  void line(std::span<const Point> points, Colour colour, double width) override;
  void segments(std::span<const Point> ends, Colour colour, double width) override;
  void text(Point at, std::string_view utf8, double height, Colour colour,
            Align align = Align::left) override;
  [[nodiscard]] double text_width(std::string_view utf8, double height) const override;
  void clip(const Box& box) override;
  void unclip() override;

 private:
  void append_disc(const Disc& disc);
  void append_ring(const Disc& disc);
  void append_band(std::span<const Point> points, Colour colour, double width, std::size_t hidden);

  sf::RenderTarget& target_;
  sf::Font font_;
  bool has_font_ = false;
  sf::Texture atlas_;
  std::vector<sf::Vertex> vertices_;
  std::vector<Point> ring_;
};

}  // namespace clapotis
