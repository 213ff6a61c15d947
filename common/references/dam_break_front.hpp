#pragma once

#include <array>
#include <span>
#include <string_view>

namespace clapotis {

/// How far the water had run when: T = t sqrt(2g/a) and Z = x/a, without units, for a column of width a and
/// height 2a that is set free at t = 0 on a dry bed; x is measured from the wall behind the column, so Z = 1
/// at the start.
struct FrontReading {
  double time;   ///< T
  double front;  ///< Z
};

/// The front of a dam break as an experiment saw it.
///
/// The readings come from the figures of the papers, to 1 or 2 % of the axes. The experiments differ among
/// themselves by up to 12 %, and stay 0.2 a or so behind good inviscid computations, which agree with each
/// other to 0.02 a: to agree with one of them to 1 % proves nothing.
struct FrontExperiment {
  std::string_view name;    ///< authors, year, and the column where there are several
  std::string_view source;  ///< paper and figure, and who read it
  std::span<const FrontReading> readings;

  /// Z at T, linear between readings; NaN before the first and after the last, and for NaN.
  double front(double time) const;
};

namespace readings {

inline constexpr std::array<FrontReading, 9> koshizuka_oka{{
    {0.0, 1.000},
    {0.381, 1.111},
    {0.769, 1.252},
    {1.153, 1.505},
    {1.537, 1.892},
    {1.935, 2.241},
    {2.323, 2.615},
    {2.719, 3.003},
    {3.096, 3.624},
}};

inline constexpr std::array<FrontReading, 10> martin_moyce_small{{
    {0.849, 1.245},
    {1.212, 1.443},
    {1.602, 1.884},
    {2.283, 2.689},
    {2.950, 3.728},
    {3.598, 4.528},
    {3.905, 4.999},
    {4.592, 5.841},
    {4.961, 6.271},
    {5.316, 6.717},
}};

inline constexpr std::array<FrontReading, 15> martin_moyce_large{{
    {0.832, 1.217},
    {1.219, 1.474},
    {1.997, 2.292},
    {2.547, 2.995},
    {3.345, 4.134},
    {4.034, 4.944},
    {4.418, 5.881},
    {5.091, 6.980},
    {5.685, 7.945},
    {6.306, 8.966},
    {6.822, 9.986},
    {7.439, 10.963},
    {8.031, 11.977},
    {8.633, 13.005},
    {9.237, 13.970},
}};

}  // namespace readings

/// a = 14.6 cm.
inline constexpr FrontExperiment koshizuka_oka_1996{
    "Koshizuka & Oka 1996",
    "S. Koshizuka, Y. Oka, Nucl. Sci. Eng. 123 (1996) 421-434, their experiment, "
    "as read by the authors of PySPH",
    readings::koshizuka_oka};

/// a = 1.125 in = 2.8575 cm.
inline constexpr FrontExperiment martin_moyce_1952_small{
    "Martin & Moyce 1952, a = 2.86 cm",
    "J. C. Martin, W. J. Moyce, Phil. Trans. R. Soc. Lond. A 244 (1952) 312-324, figure 3, n^2 = 2, "
    "a = 1.125 in, as read by the authors of PySPH",
    readings::martin_moyce_small};

/// a = 2.25 in = 5.715 cm. Between T = 4.03 and 4.42 the front leaps, faster than shallow water can go
/// (Ritter 1892: dZ/dT = 2): compare before it.
inline constexpr FrontExperiment martin_moyce_1952_large{
    "Martin & Moyce 1952, a = 5.72 cm",
    "J. C. Martin, W. J. Moyce, Phil. Trans. R. Soc. Lond. A 244 (1952) 312-324, figure 3, n^2 = 2, "
    "a = 2.25 in, as read by the authors of PySPH",
    readings::martin_moyce_large};

/// All three, for loops.
inline constexpr std::array<FrontExperiment, 3> dam_break_fronts{koshizuka_oka_1996, martin_moyce_1952_small,
                                                                 martin_moyce_1952_large};

}  // namespace clapotis
