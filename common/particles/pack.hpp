#pragma once

#include <experimental/simd>

#include "common/particles/vec.hpp"

namespace clapotis {

/// As many doubles as one instruction of this machine works on: what a pair law computes with (8 with AVX-512, 4
/// with AVX2, 2 with SSE2). It has + - * /, and min, max, sqrt, select below, but no `if` on its values.
using Pack = std::experimental::native_simd<double>;

inline constexpr long pack_width = static_cast<long>(Pack::size());

inline Pack max(const Pack& a, double b) { return std::experimental::max(a, Pack(b)); }
inline Pack min(const Pack& a, double b) { return std::experimental::min(a, Pack(b)); }
using std::experimental::sqrt;

/// `yes` where `condition` holds, `no` elsewhere: what an `if` is for one number.
inline Pack select(const Pack::mask_type& condition, const Pack& yes, const Pack& no) {
  Pack result = no;
  where(condition, result) = yes;
  return result;
}

inline double sum(const Pack& a) { return std::experimental::reduce(a); }

/// 0, 1, 2, ...
inline const Pack& lanes() {
  static const Pack numbers([](auto lane) { return static_cast<double>(lane); });
  return numbers;
}

}  // namespace clapotis
