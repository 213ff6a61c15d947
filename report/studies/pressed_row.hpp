#pragma once

#include <memory>

#include "common/simulation/simulation.hpp"
#include "report/studies/work_precision.hpp"

namespace clapotis::studies {

/// Discs in a row between two immovable ones, each contact pressed in by `row_overlap`, with small kicks
/// along the row that open none: a chain of springs that nothing but the air damps. No scene has it, so that
/// one is made of scene stage2/pair, whose weight, walls and speeds are out of the way.
std::unique_ptr<Simulation> pressed_row(int discs, const Values& values);

inline constexpr double row_overlap = 1;  ///< [px]
inline constexpr double row_kick = 0.2;   ///< largest speed at the start [px/s]

/// Of a chain of `discs` masses m between two walls, by springs k: the highest frequency, and the lowest.
double highest_frequency(int discs, double stiffness, double mass);
double lowest_frequency(int discs, double stiffness, double mass);

}  // namespace clapotis::studies
