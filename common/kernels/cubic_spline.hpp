#pragma once

#include <numbers>
#include <string_view>

#include "common/kernels/kernel.hpp"

namespace clapotis {

/// The handout's kernel, with q = r/h: W = 10/(7 pi h^2) [(2-q)^3/4 - (1-q)^3], each cube only where it is
/// positive. Handout, section VI; Monaghan & Lattanzio 1985.
class CubicSpline {
 public:
  static constexpr std::string_view name = "cubic_spline";

  explicit CubicSpline(double h)  ///< smoothing length [L], > 0
      : h_(h),
        inverse_h_(1 / h),
        peak_(10 / (7 * std::numbers::pi * h * h)),
        slope_(3 * peak_ * inverse_h_) {}

  [[gnu::always_inline]] auto value(const auto& r) const {
    const auto q = r * inverse_h_;
    const auto outer = max(2.0 - q, 0.0), inner = max(1.0 - q, 0.0);
    return peak_ * (0.25 * outer * outer * outer - inner * inner * inner);
  }
  [[gnu::always_inline]] auto slope_over_r(const auto& r, const auto& inverse_r) const {
    const auto q = r * inverse_h_;
    const auto outer = max(2.0 - q, 0.0), inner = max(1.0 - q, 0.0);
    return slope_ * inverse_r * (inner * inner - 0.25 * outer * outer);
  }
  [[nodiscard]] double support() const { return 2 * h_; }

 private:
  double h_, inverse_h_, peak_, slope_;
};
static_assert(Kernel<CubicSpline>);

}  // namespace clapotis
