#pragma once

#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "common/simulation/simulation.hpp"

namespace clapotis::studies {

/// Discs in a row between two immovable ones, each contact pressed in by 1 px, with kicks along the row that
/// are too small to open one: a chain of springs that nothing but the air damps. No scene has it, so that it
/// is made of stage2/pair, whose weight and walls are out of the way; `values` are for that scene.
std::unique_ptr<Simulation> pressed_row(int discs,
                                        const std::vector<std::pair<std::string, std::string>>& values);

/// The highest frequency of such a chain, of masses m and springs k [rad/s].
double highest_frequency(int discs, double stiffness, double mass);

}  // namespace clapotis::studies
