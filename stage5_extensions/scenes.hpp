#pragma once

#include "common/simulation/scene.hpp"

namespace clapotis::stage5 {

/// Stage 5: what the handout proposes beyond the liquid, each a scene that pays only for what it names.
Stage stage();

// Flow between plates, periodic along x: channel.cpp.
Setup poiseuille(Parameters& p);
Setup couette(Parameters& p);

// A tank of water with a surface that moves: waves.cpp.
Setup standing_wave(Parameters& p);
Setup sloshing(Parameters& p);

// A liquid with a skin: capillarity.cpp.
Setup capillary_drop(Parameters& p);
Setup sessile_drop(Parameters& p);

}  // namespace clapotis::stage5
