#pragma once

#include "common/simulation/parameters.hpp"

/// Parameters that several laws and scenes read, written once. Scenes give them other defaults.
namespace clapotis {

inline const Parameter disc_mass{
    .name = "mass", .symbol = "m", .unit = "kg", .value = 1, .range = positive, .change = Change::restart};
inline const Parameter disc_radius{
    .name = "radius", .symbol = "h", .unit = "L", .value = 10, .range = positive, .change = Change::restart};
inline const Parameter box_width{
    .name = "width", .symbol = "W", .unit = "L", .value = 800, .range = positive, .change = Change::restart};
inline const Parameter box_height{
    .name = "height", .symbol = "H", .unit = "L", .value = 600, .range = positive, .change = Change::restart};
inline const Parameter start_x{
    .name = "x0", .symbol = "x0", .unit = "L", .value = 0, .change = Change::restart};
inline const Parameter start_y{
    .name = "y0", .symbol = "y0", .unit = "L", .value = 0, .change = Change::restart};
inline const Parameter start_vx{
    .name = "vx0", .symbol = "vx0", .unit = "L/s", .value = 0, .change = Change::restart};
inline const Parameter start_vy{
    .name = "vy0", .symbol = "vy0", .unit = "L/s", .value = 0, .change = Change::restart};
inline const Parameter slip_along_walls{.name = "slip", .symbol = "", .unit = "", .choices = {"free", "no"}};

}  // namespace clapotis
