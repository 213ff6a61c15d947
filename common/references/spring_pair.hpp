#pragma once

namespace clapotis {

/// Two discs on the x axis that meet head-on and repel with f = +-k (2h - |x2 - x1|) while they overlap: the
/// gap closes at constant speed V, then overlaps as (V/w) sin(w (t - t_begin)), w^2 = k/mu with the reduced
/// mass mu = m1 m2/(m1 + m2), for a time pi/w, then opens at the same speed V (restitution 1). The centre of
/// mass moves uniformly. Handout, section IV; Landau & Lifshitz, Mechanics, section 13, for the reduction to
/// mu.
///
/// All functions throw std::invalid_argument if a mass, the radius or the stiffness is not finite and > 0, if
/// a position or speed is not finite, if the discs overlap at t = 0, or if they meet so fast that their
/// centres would pass through each other (V/w >= 2h).
struct SpringPair {
  double stiffness;  ///< k [N/m], > 0
  double radius;     ///< h [m], > 0, of both
  double mass1;      ///< m1 [kg], > 0
  double mass2;      ///< m2 [kg], > 0
  double x1, x2;     ///< centres at t = 0 [m], at least 2h apart, in either order
  double v1, v2;     ///< speeds at t = 0 [m/s]

  struct State {
    double x1, x2;  ///< [m]
    double v1, v2;  ///< [m/s]
  };

  State at(double t) const;          ///< at t [s], of either sign
  double angular_frequency() const;  ///< w = sqrt(k/mu) [rad/s]
  double contact_begin() const;      ///< [s], infinity for discs that never meet
  double contact_end() const;        ///< contact_begin() + pi/w [s]
  double max_overlap() const;        ///< V/w [m], zero for discs that never meet
};

/// Factor by which one step of explicit Euler multiplies the energy of an oscillator: 1 + (w dt)^2.
double explicit_euler_amplification(double w_dt);

/// Restitution that explicit Euler gives to a contact that should have 1: the amplification over the
/// pi/(w dt) steps of the contact, as a factor on the speed. A mean: one contact is a whole number of steps.
double explicit_euler_restitution(double w_dt);

}  // namespace clapotis
