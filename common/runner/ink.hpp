#pragma once

#include <string_view>

#include "common/runner/canvas.hpp"

namespace clapotis::ink {

// Colours and sizes that pictures and plots share. Sizes are pixels of a 1280 x 720 sheet; each is multiplied
// by the picture's scale. On a sheet of that size 18 pixels are 1/40 of the height: the least that the back
// row can read.

inline constexpr Colour sheet{0.957F, 0.965F, 0.973F};
inline constexpr Colour paper{1.0F, 1.0F, 1.0F};
inline constexpr Colour text{0.11F, 0.14F, 0.18F};
inline constexpr Colour faint_text{0.33F, 0.37F, 0.42F};
inline constexpr Colour wall{0.20F, 0.24F, 0.29F};
inline constexpr Colour grid{0.78F, 0.80F, 0.83F};
inline constexpr Colour plain_disc{0.16F, 0.42F, 0.69F};
inline constexpr Colour ghost{0.80F, 0.20F, 0.10F};
inline constexpr Colour chosen{0.90F, 0.45F, 0.00F};
inline constexpr Colour in_vain{0.99F, 0.80F, 0.58F};        ///< around what was tested and is out of reach
inline constexpr Colour visited{0.99F, 0.80F, 0.58F, 0.5F};  ///< cells that were looked through

inline constexpr double title = 28, words = 20, numbers = 18;
inline constexpr double margin = 20;

/// Text no wider than `room` [pixel]: its height shrinks, to 60 % at the least, then its end is cut off.
void fitted_text(Canvas& canvas, Point at, std::string_view utf8, double height, double room, Colour colour,
                 Align align = Align::left);

}  // namespace clapotis::ink
