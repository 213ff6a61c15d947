#pragma once

#include "common/simulation/simulation.hpp"

/// What a hand can do to a liquid that runs: each between two steps, each from then on part of the run. What
/// cannot be done throws BadInput, in a sentence, and changes nothing. Places and lengths in the scene's unit
/// [L].
namespace clapotis {

/// Pulls (1) the liquid towards `at`, or pushes (-1) it away; 0 lets it go.
void hold_hand(Simulation& simulation, const Vector& at, double pull);
/// Moves the tank with this acceleration from now on [L/s^2].
void shake_tank(Simulation& simulation, const Vector& acceleration);
/// Neither, if it did one of them.
void let_go(Simulation& simulation);
/// Adds a drop of liquid at rest, around `at`, where there is room for it.
void add_drop(Simulation& simulation, const Vector& at, double radius);
/// Takes away the liquid and the obstacles around `at`.
void erase(Simulation& simulation, const Vector& at, double radius);
/// Puts a round obstacle there, made of the particles of walls. There must be no liquid in its place.
void draw_obstacle(Simulation& simulation, const Vector& at, double radius);

/// Whether the scene's liquid has a hand.
[[nodiscard]] bool has_hand(const Simulation& simulation);

}  // namespace clapotis
