#pragma once

#include <vector>

#include "common/runner/describe.hpp"
#include "common/runner/history.hpp"
#include "common/runner/sheet.hpp"
#include "stage3_grid/scenes.hpp"

namespace clapotis::testing {

/// A sheet with all that can be painted: discs, rings, lines, cells, text, clipped or not.
struct ExampleSheet {
  ExampleSheet() {
    const Stage stage = stage3::stage();
    Simulation simulation(stage.scene("cloud"));
    History history;
    for (int k = 0; k < 1200; ++k) {
      simulation.step();
      history.add(simulation);
    }
    Viewpoint viewpoint;
    viewpoint.grid = true;
    viewpoint.chosen = 250;
    picture = describe(stage.title, simulation, viewpoint);
    plots = clapotis::plots(history, simulation);
  }
  Picture picture;
  std::vector<Plot> plots;
};

}  // namespace clapotis::testing
