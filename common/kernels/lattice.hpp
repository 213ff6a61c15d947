#pragma once

#include <cmath>

#include "common/kernels/kernel.hpp"

namespace clapotis {

/// Sums over the square lattice of spacing dx around one of its points, itself included: how well the kernel
/// integrates there.
struct LatticeSums {
  double value;     ///< dx^2 sum W, ideally 1
  double gradient;  ///< -dx^2 sum x dW/dx, ideally 1
  int neighbours;   ///< within the support
};

template <Kernel K>
LatticeSums lattice_sums(const K& kernel, double dx) {
  const int reach = static_cast<int>(kernel.support() / dx) + 1;
  LatticeSums sums{dx * dx * kernel.value(0.0), 0, 0};
  for (int a = -reach; a <= reach; ++a)
    for (int b = -reach; b <= reach; ++b) {
      const double r = dx * std::hypot(a, b);
      if (r == 0 || r >= kernel.support()) continue;
      sums.value += dx * dx * kernel.value(r);
      sums.gradient -= dx * dx * (a * dx) * (a * dx) * kernel.slope_over_r(r, 1 / r);
      ++sums.neighbours;
    }
  return sums;
}

}  // namespace clapotis
