#pragma once

#include <cmath>

#include "tests/common/discs.hpp"

/// The formula of the handout, pair by pair, one number at a time: what the sweeps are measured against.
namespace clapotis::tests {

struct BruteForce {
  Vectors acceleration;  ///< by the contacts
  Column scale;          ///< sum of the contacts' magnitudes: what round-off is measured by
  double elastic = 0;
  long long neighbours = 0;  ///< ordered pairs
};

/// f_i = k (2h - r) u for r < 2h, u from j to i. Handout, section IV.
inline BruteForce brute_force(const Discs& discs, double k = 1, double h = 0.5) {
  const Index n = discs.position.rows();
  BruteForce sum{Vectors::Zero(n, 2), Column::Zero(n)};
  for (Index i = 0; i < n; ++i)
    for (Index j = 0; j < n; ++j) {
      const double dx = discs.position(i, 0) - discs.position(j, 0);
      const double dy = discs.position(i, 1) - discs.position(j, 1);
      const double r = std::sqrt(dx * dx + dy * dy);
      if (i == j || !(r < 2 * h)) continue;
      const double force = k * (2 * h - r);
      sum.acceleration(i, 0) += force * dx / r / discs.mass(i);
      sum.acceleration(i, 1) += force * dy / r / discs.mass(i);
      sum.scale(i) += k * 2 * h / discs.mass(i);
      sum.elastic += force * force / k / 4;  // each pair is met twice
      ++sum.neighbours;
    }
  return sum;
}

/// The largest difference of two accelerations, each by its own scale.
inline double difference(const Vectors& a, const BruteForce& exact) {
  const Column most = (a - exact.acceleration).abs().rowwise().maxCoeff();
  return (most / (exact.scale + 1e-300)).maxCoeff();
}

}  // namespace clapotis::tests
