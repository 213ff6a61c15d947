#pragma once

#include <cstdint>

#include "common/particles/particles.hpp"

namespace clapotis {

/// A rectangle, for centres of particles [L].
struct Rectangle {
  double left, right, bottom, top;
};

/// Centres of `count` discs of radius h in `room`, none overlapping: the widest hexagonal lattice with enough
/// places, filled from below, each centre moved at random by as much as its neighbours leave it. The same
/// seed gives the same places on every machine. Throws BadInput, saying how many fit, when the discs would
/// overlap.
Vectors scattered_discs(Index count, double h, const Rectangle& room, std::uint64_t seed,
                        std::string_view unit);

}  // namespace clapotis
