#pragma once

#include <Eigen/Core>
#include <string_view>
#include <vector>

namespace clapotis::studies {

/// x'' = -K x - C x', in as many unknowns as the matrices have rows.
struct Oscillator {
  Eigen::MatrixXd stiffness, damping;  ///< K [1/s^2] and C [1/s]
};

/// The factor by which a step multiplies the fastest growing motion: theory of linear stability, the spectral
/// radius of what the scheme does to (x, v, a).
double amplification(std::string_view scheme, const Oscillator& oscillator, double dt);

/// The shortest dt with which one of them grows by more than `growth` per step, looked for from `shortest` on
/// in steps of 1 % and then halved down; infinity if there is none up to `longest`.
double stability_limit(std::string_view scheme, const std::vector<Oscillator>& oscillators, double growth,
                       double shortest, double longest);

/// The waves of a square lattice of SPH particles at rest, dx = c = rho_0 = 1, pressure 0: for each of the
/// wave vectors that side x side periodic particles have. The density sum gives w^2 = |g|^2 with
/// g = sum_j m grad W sin(k.d), for displacements along g. The viscosity of approaching pairs counts with
/// half of its alpha, for a pair approaches half of the time.
std::vector<Oscillator> lattice_waves(std::string_view kernel, double h, double alpha, int side);

}  // namespace clapotis::studies
