#pragma once

namespace clapotis {

/// Frequency of small waves on a liquid without viscosity: w = sqrt(g k tanh(k H)) [1/s], k = 2 pi/lambda
/// [1/m] > 0, H its depth [m] > 0. Lamb, Hydrodynamics, art. 228.
double wave_frequency(double gravity, double k, double depth);

/// How a small wave on deep viscous water goes on: amplitude ~ exp(-decay t) cos(frequency t).
struct ViscousWave {
  double frequency;  ///< [1/s]
  double decay;      ///< [1/s]
};
/// The root n = -decay + i frequency of (n + 2 nu k^2)^2 + g k = 4 nu^2 k^3 sqrt(k^2 + n/nu). As nu goes to
/// 0, decay tends to 2 nu k^2. Lamb, Hydrodynamics, art. 349. For nu > 0, and small enough that the wave
/// oscillates.
ViscousWave viscous_wave(double gravity, double k, double viscosity);

/// The surface of a liquid in a tank that from rest sways, X(t) = A (1 - cos W t), and rolls about the middle
/// of its floor, counterclockwise by theta(t) = B (1 - cos W t), in the tank's frame, by linear theory:
///   eta = sum over odd n of b_n cos(k_n x),  k_n = n pi/L,  w_n^2 = g k_n tanh(k_n H),
///   b_n'' + w_n^2 b_n = 4 tanh(k_n H)/(k_n L) [X'' + g theta - theta'' (H - 2/k_n tanh(k_n H/2))].
/// The bracket is the push along x that a solid would feel, but for the last term: a liquid does not turn
/// with its tank (its potential is that of Stokes and Joukowski). Faltinsen & Timokha 2009, Sloshing,
/// chapter 5.
struct MovedTank {
  double width;      ///< L [m], > 0
  double depth;      ///< H [m], > 0
  double gravity;    ///< g [m/s^2], > 0
  double amplitude;  ///< A [m]
  double angle;      ///< B [rad]
  double omega;      ///< W [1/s], > 0

  /// w_n [1/s].
  [[nodiscard]] double natural_frequency(int n) const;
  /// eta(x, t) [m], x from the left wall, the first 200 modes: right to 1e-3 (A W^2/g + B) L.
  [[nodiscard]] double elevation(double x, double t) const;
  /// The greatest |eta| at the walls up to time t, of some hundred instants [m].
  [[nodiscard]] double greatest(double t) const;
};

}  // namespace clapotis
