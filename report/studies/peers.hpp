#pragma once

#include <functional>
#include <optional>
#include <vector>

namespace clapotis::studies {

/// What PySPH's elliptical drop came to, side by side on this machine.
struct PeerDrop {
  double b_error = 0, b_largest = 0;            ///< of the semi-axis b, at the end and over the run
  double energy_error = 0, energy_largest = 0;  ///< of the kinetic energy
  double seconds = 0;                           ///< processor time of the steps alone
  long steps = 0, particles = 0;
};

/// Runs PySPH's drop by report/bench/peers/pysph_elliptical_drop.py when a resolution R/dx is first asked
/// for: all of them in one process, since it compiles for half a minute, in the given order. Nothing where
/// PySPH is not installed.
std::function<std::optional<PeerDrop>(int)> run_pysph_drops(std::vector<int> resolutions);

}  // namespace clapotis::studies
