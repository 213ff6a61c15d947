#pragma once

#include <cmath>

#include "common/particles/particles.hpp"

namespace clapotis::tests {

/// Of all particles together.
struct Momenta {
  Vector linear{0, 0};
  double angular = 0;
  double magnitude = 0, angular_magnitude = 0;  ///< sums of |p| and |r||p|
};

inline Momenta momenta(const Particles& p) {
  Momenta sum;
  for (Index i = 0; i < p.size(); ++i) {
    const Vector r = row(p.position, i), mv = p.mass(i) * row(p.velocity, i);
    sum.linear += mv;
    sum.angular += r.x * mv.y - r.y * mv.x;
    sum.magnitude += norm(mv);
    sum.angular_magnitude += norm(r) * norm(mv);
  }
  return sum;
}

/// Each vector turned about the origin [rad].
inline Vectors turned(const Vectors& a, double angle) {
  Vectors result(a.rows(), 2);
  result.col(0) = std::cos(angle) * a.col(0) - std::sin(angle) * a.col(1);
  result.col(1) = std::sin(angle) * a.col(0) + std::cos(angle) * a.col(1);
  return result;
}

}  // namespace clapotis::tests
