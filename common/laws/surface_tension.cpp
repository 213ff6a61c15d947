#include "common/laws/surface_tension.hpp"

#include <Eigen/QR>

namespace clapotis {
namespace {

using std::numbers::pi;

/// Sums over one row of particles, as seen from a particle of another: of V W'/r times ...
struct RowSums {
  double lift = 0, lift_by_tension = 0;        ///< ... d_y, without and with the profile of the tension
  double surplus = 0, surplus_by_tension = 0;  ///< ... d_y^2 - d_x^2
};

/// The row at `below` smoothing lengths under the particle; its particles are `pitch` apart, the first at
/// `first`. All in smoothing lengths.
RowSums sums_of_row(double below, double first, double pitch, double volume) {
  const WendlandC2 kernel(1);
  const double reach = kernel.support();
  RowSums sums;
  for (double x = first - std::ceil((reach + first) / pitch) * pitch; x < reach; x += pitch) {
    const double r = std::hypot(x, below);
    if (r < 1e-9 || r >= reach) continue;
    const double weight = volume * kernel.slope_over_r(r, 1 / r),
                 tension = SurfaceTension::profile(r / reach);
    const double surplus = below * below - x * x;
    sums.lift += weight * below;
    sums.lift_by_tension += weight * tension * below;
    sums.surplus += weight * surplus;
    sums.surplus_by_tension += weight * tension * surplus;
  }
  return sums;
}

}  // namespace

double SurfaceTension::tension_of_flat_surface(double h_over_dx) {
  const double volume = 1 / (h_over_dx * h_over_dx);
  const double pitch = std::sqrt(2 / std::sqrt(3) * volume), row = volume / pitch;
  const auto rows = static_cast<Index>(std::ceil(10 / row)), within = static_cast<Index>(2 / row);
  // The deepest rows have no pressure: they are what the others rest on.
  const Index free = rows - within - 1;
  const auto seen = [&](Index k, Index l) {
    const bool shifted = (k - l) % 2 != 0;
    return sums_of_row(static_cast<double>(l - k) * row, shifted ? pitch / 2 : 0, pitch, volume);
  };
  // Row k is at rest: sum over l of -(p_k + p_l) lift + lift by tension = 0.
  Eigen::MatrixXd lift = Eigen::MatrixXd::Zero(free, free);
  Eigen::VectorXd by_tension = Eigen::VectorXd::Zero(free);
  for (Index k = 0; k < free; ++k)
    for (Index l = std::max<Index>(0, k - within); l <= k + within; ++l) {
      const auto sums = seen(k, l);
      lift(k, k) += sums.lift;
      if (l < free) lift(k, l) += sums.lift;
      by_tension(k) += sums.lift_by_tension;
    }
  const Eigen::VectorXd solved = lift.colPivHouseholderQr().solve(by_tension);
  const auto pressure = [&](Index k) { return k < free ? solved(k) : 0; };
  double sigma = 0;
  for (Index k = 0; k < free; ++k)
    for (Index l = std::max<Index>(0, k - within); l <= k + within; ++l) {
      const auto sums = seen(k, l);
      sigma += row / 2 * (sums.surplus_by_tension - (pressure(k) + pressure(l)) * sums.surplus);
    }
  return sigma;
}

SurfaceTension SurfaceTension::from(Parameters& p) {
  const auto fluid = Fluid::from(p);
  SurfaceTension law{};
  law.sigma = p.number(parameter());
  law.h = fluid.h;
  law.reference_density = fluid.state.reference_density;
  const double a = law.sigma / (fluid.h * tension_of_flat_surface(fluid.h / fluid.spacing));
  law.strength = a / (law.reference_density * law.reference_density);
  const auto* angle = p.find(angle_parameter().name);
  law.wetting = angle == nullptr ? 0 : wetting_for(angle->value * pi / 180);

  const double volume = fluid.mass / law.reference_density;
  law.pair_energy_at_zero = 35 / (24 * pi * fluid.h * fluid.h) * a * volume * volume;
  const int reach = static_cast<int>(2 * fluid.h / fluid.spacing) + 1;
  for (int column = -reach; column <= reach; ++column)
    for (int line = -reach; line <= reach; ++line)
      law.energy_of_bulk += law.pair_energy(fluid.spacing * std::hypot(column, line)) / 2;
  return law;
}

}  // namespace clapotis
