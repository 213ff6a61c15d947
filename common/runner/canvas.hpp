#pragma once

#include <cstddef>
#include <span>
#include <string_view>

namespace clapotis {

/// Red, green, blue, opacity, each in [0, 1], sRGB.
struct Colour {
  float red = 0, green = 0, blue = 0, opacity = 1;
  bool operator==(const Colour&) const = default;
};

/// A point of the canvas: pixels from its upper left corner, y DOWN (the world's y points up; PictureView
/// flips it).
struct Point {
  double x = 0, y = 0;
  bool operator==(const Point&) const = default;
};

struct Box {
  Point corner;  ///< upper left [pixel]
  Point extent;  ///< width and height [pixel]
};

struct Disc {
  Point centre;
  double radius;  ///< [pixel]
  Colour colour;
  double hole = 0;  ///< radius of a concentric hole [pixel]; above 0 the disc is a ring
};

enum class Align { left, centre, right };

/// What a picture is painted on: Cairo without a display, OpenGL in the window. A picture that is painted
/// through this interface is the same in both.
class Canvas {
 public:
  virtual ~Canvas() = default;
  [[nodiscard]] virtual Point size() const = 0;
  virtual void rectangle(const Box& box, Colour fill) = 0;
  /// All discs of one call are one draw call in the window. They are painted in their order, the last on top.
  virtual void discs(std::span<const Disc> discs) = 0;
  /// One polyline, its joins round and its ends square.
  virtual void line(std::span<const Point> points, Colour colour, double width) = 0;
  /// Separate straight pieces: ends[0] to ends[1], ends[2] to ends[3], ... One draw call in the window, where
  /// a `line` for each would be hundreds (grids, ticks, dashes).
  virtual void segments(std::span<const Point> ends, Colour colour, double width) {
    for (std::size_t k = 0; k + 1 < ends.size(); k += 2) line(ends.subspan(k, 2), colour, width);
  }
  /// `at` is the left, centre or right end of the text's baseline; `height` is the font size [pixel].
  virtual void text(Point at, std::string_view utf8, double height, Colour colour,
                    Align align = Align::left) = 0;
  [[nodiscard]] virtual double text_width(std::string_view utf8, double height) const = 0;
  /// What follows is painted inside `box` only, until `unclip`.
  virtual void clip(const Box& box) = 0;
  virtual void unclip() = 0;
};

}  // namespace clapotis
