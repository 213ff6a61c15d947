#pragma once

#include <array>

/// What PySPH 1.0b1, as Debian ships it, finds with its own examples on two cases, measured for this project
/// with report/bench/peers/pysph_*.py: another program to stand beside, not the truth.
namespace clapotis::pysph {

/// pysph.examples.elliptical_drop at t A0 = 0.76: WCSPH, Gaussian kernel, h/dx = 1.3, alpha = 0.1, c = 14 R
/// A0. Errors are relative.
struct Drop {
  int cells;       ///< R/dx
  double b_error;  ///< of the semi-axis b, by the outermost particle
  double energy_error;
};
inline constexpr std::array drops{Drop{20, -0.0198, -0.062}, Drop{40, -0.0103, -0.031},
                                  Drop{80, -0.0055, -0.018}};

/// pysph.examples.dam_break_2d: WCSPH, Wendland C2, h/dx = 1.3, alpha = 0.1. The front is the centre of the
/// foremost particle.
struct Front {
  double time;          ///< T = t sqrt(2g/a)
  double coarse, fine;  ///< x/a with a/dx = 32 and 50
};
inline constexpr std::array fronts{Front{0.83, 1.33, 1.35}, Front{1.45, 1.90, 1.94}, Front{2.07, 2.63, 2.68},
                                   Front{2.69, 3.47, 3.52}};

}  // namespace clapotis::pysph
