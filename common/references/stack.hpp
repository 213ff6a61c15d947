#pragma once

#include <vector>

namespace clapotis {

/// A column of n equal discs at rest on a hard floor, held apart by contact springs f = k (2h - distance):
/// the contact below the m topmost discs carries m g each, so it overlaps by m (mass g)/k. Walls act on the
/// rim of a disc and do not yield: the lowest centre is at y = h and the floor pushes back with n (mass g).
/// Handout, section IV.
struct RestingStack {
  std::vector<double> heights;   ///< y of the n centres [m], from the bottom to the top
  std::vector<double> overlaps;  ///< of the n - 1 contacts between discs [m], from the bottom to the top
  double floor_force;            ///< [N], upward, on the lowest disc
};

/// count >= 1; mass [kg], stiffness k [N/m] and radius h [m] > 0; gravity g [m/s^2] >= 0, downward.
/// Throws std::invalid_argument out of these ranges, and if the lowest contact would overlap by 2h or more.
RestingStack resting_stack(int count, double mass, double gravity, double stiffness, double radius);

}  // namespace clapotis
