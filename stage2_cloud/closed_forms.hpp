#pragma once

#include <optional>

#include "common/laws/walls.hpp"
#include "common/simulation/scene.hpp"

namespace clapotis::stage2 {

/// The head-on collision of the two particles, in closed form until one of them reaches a wall; nothing where
/// weight or drag act as well, where the two overlap from the start, or meet so fast that they would pass
/// through each other.
std::optional<Reference> head_on_collision(const Parameters& p, const Particles& particles,
                                           const Walls& walls);

/// The column of n discs at rest: the n-th contact from the top overlaps by n m g/k. Nothing where the
/// springs are too soft to carry it.
std::optional<Reference> column_at_rest(const Parameters& p, Index n);

/// Throws BadInput when a column of n discs is higher than the box.
void require_height(const Parameters& p, Index n, double radius);

}  // namespace clapotis::stage2
