#pragma once

#include <concepts>

#include "common/particles/pack.hpp"

namespace clapotis {

/// A smoothing kernel W(r) of the plane: radial, its integral 1, zero at and beyond its support 2h. Both
/// functions take one number, or a pack of them.
///
/// - `value(r)`: W [1/L^2]
/// - `slope_over_r(r, inverse_r)`: W'(r)/r [1/L^4], so that grad_i W = W'/r d with d = r_i - r_j; `inverse_r`
///   is 1/r, or anything large where r is 0: there the product with d is 0
/// - `support()`: 2h [L]
template <class K>
concept Kernel = requires(const K& kernel, const Pack& pack, double number) {
  { kernel.value(number) } -> std::same_as<double>;
  { kernel.value(pack) } -> std::same_as<Pack>;
  { kernel.slope_over_r(number, number) } -> std::same_as<double>;
  { kernel.slope_over_r(pack, pack) } -> std::same_as<Pack>;
  { kernel.support() } -> std::same_as<double>;
};

}  // namespace clapotis
