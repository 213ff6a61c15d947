#pragma once

#include <cmath>
#include <string>
#include <utility>

#include "common/simulation/scene.hpp"
#include "stage4_sph/liquid.hpp"
#include "tests/common/discs.hpp"

/// What the tests of stage 4 share: particles of a fluid at places of the test's choice.
namespace clapotis::tests {

struct Cloud {
  Vectors position, velocity;
  Column density = {};     ///< [kg/m^3]; where it is a sum, and where this is empty, it is not set
  bool in_tank = false;    ///< with weight, in a tank whose walls are as the parameters say
  Vector period = {0, 0};  ///< of the plane, without a tank [m]
  bool corrected = false;  ///< with the tensile correction, without a tank
  double fastest = 1;      ///< a tenth of the sound speed [m/s]
};

/// Particles scattered at random over a square of that side in metres, of the spacing 0.05 m on average, with
/// random velocities up to 1 m/s and densities within a few per cent of water's.
inline Cloud random_cloud(double side, std::uint64_t seed, double spacing = 0.05) {
  const auto n = static_cast<Index>(std::lround(side * side / (spacing * spacing)));
  Cloud cloud{.position = random_points(n, {0, side, 0, side}, seed),
              .velocity = random_points(n, {-1, 1, -1, 1}, seed + 1)};
  cloud.density = 1000 * random_points(n, {0.97, 1.05, 0, 1}, seed + 2).col(0);
  return cloud;
}

/// The scene of the cloud: the liquid of stage 4, its laws, and its parameters.
inline Scene scene_of(Cloud cloud) {
  const auto build = [cloud = std::move(cloud)](Parameters& p) {
    if (cloud.corrected)
      p.number({.name = "epsilon", .symbol = "", .unit = "", .value = 0.2, .range = not_negative});
    const Fluid fluid = stage4::liquid(p, cloud.fastest);
    Setup setup{.particles = stage4::particles_at(cloud.position, p),
                .model = nullptr,
                .radius = fluid.spacing / 2,
                .fluid = fluid};
    setup.particles.velocity = cloud.velocity;
    if (cloud.density.size() > 0) setup.particles.density = cloud.density;
    if (cloud.in_tank)
      setup.model = stage4::tank_model(p, stage4::tank(p, fluid).walls);
    else
      setup.model = stage4::free_model(p, {.corner = {0, 0}, .length = cloud.period});
    return setup;
  };
  return {.name = "cloud", .length_unit = "m", .defaults = {{"spacing", "0.05"}}, .build = build};
}

}  // namespace clapotis::tests
