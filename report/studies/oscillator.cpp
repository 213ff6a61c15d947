#include "report/studies/oscillator.hpp"

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "common/kernels/cubic_spline.hpp"
#include "common/kernels/lattice.hpp"
#include "common/kernels/wendland_c2.hpp"

namespace clapotis::studies {
namespace {

using Matrix = Eigen::MatrixXd;

/// State (x, v) after a step of length 1, from the state before: 1 + L + L^2/2 ..., to the order of the
/// scheme.
Matrix runge_kutta(const Matrix& rates, int order) {
  Matrix step = Matrix::Identity(rates.rows(), rates.rows()), term = step;
  for (int k = 1; k <= order; ++k) step += term = term * rates / k;
  return step;
}

/// What the scheme makes of (x, v), or of (x, v, a) where a step uses the acceleration before. dt = 1.
Matrix step_of(std::string_view scheme, const Matrix& k, const Matrix& c) {
  const auto n = k.rows();
  const Matrix one = Matrix::Identity(n, n), zero = Matrix::Zero(n, n);
  Matrix rates(2 * n, 2 * n);
  rates << zero, one, -k, -c;
  if (scheme == "explicit_euler") return runge_kutta(rates, 1);
  if (scheme == "rk2") return runge_kutta(rates, 2);
  if (scheme == "rk4") return runge_kutta(rates, 4);
  if (scheme == "symplectic_euler") {
    Matrix step(2 * n, 2 * n);
    step << one - k, one - c, -k, one - c;  // v - K x - C v, and x moves with it
    return step;
  }
  // Verlet: half = v + a/2, x' = x + half, a' = -K x' - C (half + a/2), v' = half + a'/2
  Matrix x(n, 3 * n), half(n, 3 * n), predicted(n, 3 * n);
  half << zero, one, one / 2;
  predicted << zero, one, one;
  x << one, zero, zero;
  x += half;
  const Matrix a = -k * x - c * predicted;
  Matrix step(3 * n, 3 * n);
  step << x, half + a / 2, a;
  return step;
}

std::vector<Oscillator> waves(const auto& kernel, double h, double alpha, int side) {
  const double mass = 1 / lattice_sums(kernel, 1).value;  // rho_0 = 1 is the density sum of the lattice
  const int reach = static_cast<int>(kernel.support());
  std::vector<Oscillator> all;
  for (int a = 0; a <= side / 2; ++a)
    for (int b = 0; b <= a; ++b) {  // the others are their mirror images
      const Eigen::Vector2d k = 2 * std::numbers::pi / side * Eigen::Vector2d(a, b);
      Eigen::Vector2d g = Eigen::Vector2d::Zero();
      Matrix damping = Matrix::Zero(2, 2);
      for (int x = -reach; x <= reach; ++x)
        for (int y = -reach; y <= reach; ++y) {
          const Eigen::Vector2d d(x, y);
          const double r = d.norm();
          if (r == 0 || r >= kernel.support()) continue;
          const double slope = mass * kernel.slope_over_r(r, 1 / r);
          g += slope * std::sin(k.dot(d)) * d;
          damping -= alpha / 2 * h * slope * (1 - std::cos(k.dot(d))) / (r * r) * d * d.transpose();
        }
      all.push_back({g * g.transpose(), damping});
    }
  return all;
}

}  // namespace

double amplification(std::string_view scheme, const Oscillator& oscillator, double dt) {
  const Matrix step = step_of(scheme, dt * dt * oscillator.stiffness, dt * oscillator.damping);
  return Eigen::EigenSolver<Matrix>(step, false).eigenvalues().cwiseAbs().maxCoeff();
}

double stability_limit(std::string_view scheme, const std::vector<Oscillator>& oscillators, double growth,
                       double shortest, double longest) {
  const auto grows = [&](double dt) {
    return std::any_of(oscillators.begin(), oscillators.end(),
                       [&](const auto& each) { return amplification(scheme, each, dt) > growth; });
  };
  double stable = 0, grown = shortest;
  while (!grows(grown)) {
    stable = grown;
    grown *= 1.01;
    if (grown > longest) return std::numeric_limits<double>::infinity();
  }
  for (int halving = 0; halving < 10 && stable > 0; ++halving) {
    const double dt = (stable + grown) / 2;
    (grows(dt) ? grown : stable) = dt;
  }
  return stable;
}

std::vector<Oscillator> lattice_waves(std::string_view kernel, double h, double alpha, int side) {
  return kernel == CubicSpline::name ? waves(CubicSpline(h), h, alpha, side)
                                     : waves(WendlandC2(h), h, alpha, side);
}

}  // namespace clapotis::studies
