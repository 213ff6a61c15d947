#pragma once

#include <memory>
#include <string>
#include <utility>

#include "common/simulation/fused_model.hpp"
#include "common/simulation/quantities.hpp"
#include "stage3_grid/scenes.hpp"

namespace clapotis {

/// The scene cloud of stage 3 with other laws in its model; where these want masses of their own, each disc
/// has one.
template <class Model>
Scene cloud_with(std::string name, bool masses = false) {
  auto scene = stage3::stage().scene("cloud");
  scene.name = std::move(name);
  scene.build = [=, cloud = scene.build](Parameters& p) {
    auto setup = cloud(p);
    if (masses) setup.particles.add_column("mass", "kg").setConstant(p.number(disc_mass));
    setup.model = std::make_unique<Model>(p);
    return setup;
  };
  return scene;
}

}  // namespace clapotis
