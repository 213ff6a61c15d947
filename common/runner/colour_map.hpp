#pragma once

#include "common/runner/canvas.hpp"

namespace clapotis {

enum class ColourMap {
  viridis,    ///< dark blue to yellow; its lightness grows evenly, so it also reads in grey and for the
              ///< colour-blind
  cool_warm,  ///< blue, grey, red: for what has a sign, zero in the middle; the grey is darker than paper, so
              ///< that particles near zero are seen on it. The colour-blind tell blue from red.
};

/// The colour of `value01`: 0 is the map's first colour, 1 its last; values outside take the end's colour.
/// NaN is `not_a_number`, which no map contains.
[[nodiscard]] Colour at(ColourMap map, double value01);

/// Magenta: a diverged particle must be seen.
inline constexpr Colour not_a_number{1.0F, 0.0F, 1.0F};

}  // namespace clapotis
