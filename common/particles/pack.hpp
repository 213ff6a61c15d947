#pragma once

#include <experimental/simd>
#ifdef __AVX512F__
#include <immintrin.h>
#endif

#include "common/particles/vec.hpp"

namespace clapotis {

/// As many doubles as one instruction of this machine works on: what a pair law computes with (8 with
/// AVX-512, 4 with AVX2, 2 with SSE2). It has + - * /, and min, max, sqrt, select below, but no `if` on its
/// values.
using Pack = std::experimental::native_simd<double>;

inline constexpr long pack_width = static_cast<long>(Pack::size());

// Always inlined, for GCC counts the many small functions inside simd, gives up, and then a call costs more
// than what is called.

[[gnu::always_inline]] inline Pack max(const Pack& a, double b) { return std::experimental::max(a, Pack(b)); }
[[gnu::always_inline]] inline Pack min(const Pack& a, double b) { return std::experimental::min(a, Pack(b)); }
using std::experimental::sqrt;

// The same words for one number, so that a formula serves both.
inline double max(double a, double b) { return a > b ? a : b; }
inline double min(double a, double b) { return a < b ? a : b; }

/// `yes` where `condition` holds, `no` elsewhere: what an `if` is for one number.
[[gnu::always_inline]] inline Pack select(const Pack::mask_type& condition, const Pack& yes, const Pack& no) {
  Pack result = no;
  where(condition, result) = yes;
  return result;
}

/// 1/sqrt(a) for a > 0, to within 2 units in the last place. Where the machine has an estimate y of 14 bits,
/// with e = 1 - a y^2 the series of y/sqrt(1 - e) up to e^3 costs a third of a square root and a division.
[[gnu::always_inline]] inline Pack inverse_sqrt(const Pack& a) {
#ifdef __AVX512F__
  const auto y = Pack(_mm512_rsqrt14_pd(static_cast<__m512d>(a)));
  const Pack e = 1.0 - a * y * y;
  return y + y * (e * (0.5 + e * (0.375 + e * 0.3125)));
#else
  return 1.0 / sqrt(a);
#endif
}

inline double sum(const Pack& a) { return std::experimental::reduce(a); }

/// 0, 1, 2, ...: the number of each lane.
inline const Pack lanes([](auto lane) { return static_cast<double>(lane); });

}  // namespace clapotis
