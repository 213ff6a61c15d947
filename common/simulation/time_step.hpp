#pragma once

#include "common/simulation/model.hpp"
#include "common/simulation/parameters.hpp"

namespace clapotis {

/// The sound speed the course computes with: c = 10 v_max, with v_max the speed of a free fall from the top
/// of the box, or from y0 where that is higher, added to the initial speed in energy: v_max^2 = v_0^2 + 2 g
/// H. Handout, section III. Reads gravity, height, y0, vx0 and vy0; what a scene does not have counts as 0.
double falling_sound_speed(const Parameters& p);

/// tau = h/c, times cfl: a sound wave crosses at most one radius per step. Handout, section III. Without
/// pressure it is a matter of accuracy, not of stability.
StepLimit acoustic_limit(double radius, double sound_speed, double cfl);

/// What `dt` and the limits make of the next step: the number the user gave, or else the smallest share x
/// limit. Throws BadInput when there is neither.
double choose_dt(double wanted, const std::vector<StepLimit>& limits);

/// The smallest limit of stability that dt is beyond; null when there is none.
const StepLimit* broken_limit(double dt, const std::vector<StepLimit>& limits);

/// The limit that sets an automatic step: the smallest share x limit.
const StepLimit& binding(const std::vector<StepLimit>& limits);

inline const Parameter step_parameter{.name = "dt",
                                      .symbol = "dt",
                                      .unit = "s",
                                      .value = std::numeric_limits<double>::quiet_NaN(),
                                      .range = positive,
                                      .automatic = true};
inline const Parameter cfl_parameter{
    .name = "cfl", .symbol = "CFL", .unit = "", .value = 1, .range = positive};

}  // namespace clapotis
