#pragma once

#include "common/laws/dummy_walls.hpp"
#include "common/references/hydrostatic.hpp"
#include "common/simulation/fluid_arrangement.hpp"
#include "common/simulation/scene.hpp"
#include "stage4_sph/parameters.hpp"

namespace clapotis::stage4 {

/// What a stage offers of kernels and forms of the density.
struct Choices {
  Parameter kernel = kernel_choice, density = density_form;
};

/// States the parameters of a liquid of the consistent formulation: spacing, h_over_dx, kernel, density,
/// reference_density, sound_speed (10 times `fastest` unless given; throws BadInput where both are 0), gamma,
/// tension, and what follows from them. Where the density is a sum, the particle's mass is such that the
/// lattice at rest sums up to rho_0.
Fluid liquid(Parameters& p, double fastest, const Choices& choices = {});

/// A tank of tank_width x tank_height, its walls of particles (walls = dummy) or planes (walls = reflect).
struct Tank {
  double width, height;
  DummyWalls walls;
};
Tank tank(Parameters& p, const Fluid& fluid);

/// The laws of the consistent formulation, for the kernel and the density that the parameters name:
/// pressure, artificial viscosity, laminar viscosity where nu is not 0, and the limits of the step; in a tank
/// weight and its walls besides.
std::unique_ptr<Model> tank_model(Parameters& p, DummyWalls walls);
std::unique_ptr<Model> free_model(Parameters& p, const Period& period = {});

/// Particles at the places, at rest, as dense as the liquid at rest.
Particles particles_at(const Vectors& places, const Parameters& p);

/// The points of a square lattice with a point at `origin`, spacing dx, for which inside(r).
Vectors lattice(double spacing, const Vector& origin, const Vector& low, const Vector& high,
                const std::function<bool(Vector)>& inside);
/// Those of a disc around one of them.
Vectors disc(double spacing, const Vector& centre, double radius);
/// Those of a rectangle, half a spacing inside its sides.
Vectors block(double spacing, double left, double right, double bottom, double top);

/// Moves each coordinate at random by at most `disturbance` spacings, the same with the same `seed`.
void disturb(Vectors& places, Parameters& p, double spacing);

/// Presses the particles, of a lattice from the floor at y = 0 up to `height`, together as the weight of the
/// liquid does: each gets the density that balances the weight above it, and the place that goes with it.
void rest_under_weight(Particles& particles, const Parameters& p, double height);

/// That liquid at rest, the depth measured from its surface, which is at compressed(height).
HydrostaticColumn at_rest(const Parameters& p);

}  // namespace clapotis::stage4
