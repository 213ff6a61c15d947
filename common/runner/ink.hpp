#pragma once

#include <array>
#include <string>
#include <string_view>
#include <vector>

#include "common/runner/canvas.hpp"

namespace clapotis::ink {

/// Light for a bright room, dark for a dark one.
enum class Theme { light, dark };
inline constexpr std::array<std::string_view, 2> theme_names{"light", "dark"};

/// The colours that pictures, plots and panel share.
struct Palette {
  Colour sheet, paper;  ///< around the scene, and behind its particles
  Colour text, faint_text;
  Colour wall, grid, plain_disc, ghost, chosen;
  Colour in_vain;  ///< around what was tested and is out of reach
  Colour visited;  ///< cells that were looked through
  /// For curves, told apart by the colour-blind: M. Okabe and K. Ito, Color Universal Design (2008).
  std::array<Colour, 6> curves;
  std::array<Colour, 3> spare;  ///< for more forces than there are curves: they have a rim
  float darkest;  ///< share of a colour map that is skipped, as its dark end would be lost on the paper
  Colour panel, field, button, accent, caution, warning;  ///< of the controls
};

/// The palette in use, as `words()` are the words in use: light unless somebody chose the other.
[[nodiscard]] const Palette& palette();
[[nodiscard]] Theme theme();
void use(Theme theme);

/// A colour of the palette in use.
class Tone {
 public:
  explicit constexpr Tone(Colour Palette::*part) : part_(part) {}
  operator Colour() const { return palette().*part_; }  // NOLINT: it stands wherever a colour may

 private:
  Colour Palette::*part_;
};

inline constexpr Tone sheet{&Palette::sheet}, paper{&Palette::paper};
inline constexpr Tone text{&Palette::text}, faint_text{&Palette::faint_text};
inline constexpr Tone wall{&Palette::wall}, grid{&Palette::grid}, plain_disc{&Palette::plain_disc},
    ghost{&Palette::ghost}, chosen{&Palette::chosen}, in_vain{&Palette::in_vain}, visited{&Palette::visited},
    warning{&Palette::warning};

inline Colour translucent(Colour c, float opacity) { return {c.red, c.green, c.blue, opacity}; }

// Sizes are pixels of a 1280 x 720 sheet; each is multiplied by the picture's scale. On a sheet of that size
// 18 pixels are 1/40 of the height: the least that the back row can read.
inline constexpr double title = 28, words = 20, numbers = 18;
inline constexpr double margin = 20;

/// Paper with a rim around it, on which something is said over a scene.
void paper_box(Canvas& canvas, const Box& box, Colour rim = grid, double width = 1);

/// Text no wider than `room` [pixel]: its height shrinks, to 60 % at the least, then its end is cut off.
void fitted_text(Canvas& canvas, Point at, std::string_view utf8, double height, double room, Colour colour,
                 Align align = Align::left);

/// A sentence in lines no wider than `room` [pixel], broken at spaces.
[[nodiscard]] std::vector<std::string> broken(const Canvas& canvas, std::string_view utf8, double height,
                                              double room);

}  // namespace clapotis::ink
