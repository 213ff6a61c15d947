#pragma once

#include <numbers>
#include <string_view>

#include "common/kernels/kernel.hpp"

namespace clapotis {

/// With q = r/h: W = 7/(4 pi h^2) (1-q/2)^4 (1+2q) for q < 2. Its Fourier transform is positive, so that
/// particles do not pair (Dehnen & Aly 2012), and its slope needs no division by r. Wendland 1995.
class WendlandC2 {
 public:
  static constexpr std::string_view name = "wendland_c2";

  explicit WendlandC2(double h)  ///< smoothing length [L], > 0
      : h_(h),
        half_inverse_h_(0.5 / h),
        peak_(7 / (4 * std::numbers::pi * h * h)),
        slope_(-5 * peak_ / (h * h)) {}

  [[gnu::always_inline]] auto value(const auto& r) const {
    const auto half_q = r * half_inverse_h_;
    const auto rest = max(1.0 - half_q, 0.0), square = rest * rest;
    return peak_ * square * square * (1.0 + 4.0 * half_q);
  }
  [[gnu::always_inline]] auto slope_over_r(const auto& r, const auto& /*inverse_r*/) const {
    const auto rest = max(1.0 - r * half_inverse_h_, 0.0);
    return slope_ * (rest * rest * rest);
  }
  [[nodiscard]] double support() const { return 2 * h_; }

 private:
  double h_, half_inverse_h_, peak_, slope_;
};
static_assert(Kernel<WendlandC2>);

}  // namespace clapotis
