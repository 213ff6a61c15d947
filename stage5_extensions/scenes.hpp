#pragma once

#include "common/simulation/scene.hpp"

namespace clapotis::stage5 {

/// Stage 5: what the handout proposes beyond the liquid, each a scene that pays only for what it names.
Stage stage();

// Flow between plates, periodic along x: channel.cpp.
Setup channel(Parameters& p);

// Continuous flows, with liquid that enters or leaves: open_flows.cpp.
Setup jet(Parameters& p);
Setup open_channel(Parameters& p);
Setup draining(Parameters& p);

// A tank for the mouse: sandbox.cpp.
Setup sandbox(Parameters& p);

// A tank of water with a surface that moves: waves.cpp.
Setup standing_wave(Parameters& p);
Setup sloshing(Parameters& p);

// A thread of honey that falls on a plate: honey.cpp.
Setup honey(Parameters& p);

// A liquid with a skin: capillarity.cpp.
Setup capillary_drop(Parameters& p);
Setup sessile_drop(Parameters& p);

}  // namespace clapotis::stage5
