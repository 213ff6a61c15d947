#pragma once

#include "stage4_sph/liquid.hpp"

/// The parameters of the scenes of stage 5 that stage 4 has not, written once.
namespace clapotis::stage5 {

using stage4::detail::choice;
using stage4::detail::number;

// The kernel and the density that stage 4 found best for flows with walls.
inline const stage4::Choices wendland_continuity{.kernel = choice("kernel", {"wendland_c2"}),
                                                 .density = choice("density", {"continuity"})};

inline const auto channel_depth = number("depth", "d", "L", 1e-3);
inline const auto channel_length = number("length", "L", "L", 4e-4);
inline const auto plate_speed = number("plate_speed", "U", "L/s", 1.25e-5, any_number);
inline const auto jet_width = number("jet_width", "d", "L", 0.1);
inline const auto jet_speed = number("jet_speed", "U", "L/s", 1);
inline const auto jet_height = number("jet_height", "H", "L", 0.3);
inline const auto plate_width = number("plate_width", "W", "L", 0.6);
inline const auto film_depth = number("depth", "d", "L", 0.01);
inline const auto film_viscosity = number("nu", "nu", "L^2/s", 5e-4);
inline const auto reach = number("length", "L", "L", 0.05);
inline const auto slot_width = number("slot_width", "b", "L", 0.1);
inline const auto viscous_step = choice("viscous_step", {"explicit", "implicit"});
inline const auto probe_x = number("probe_x", "x_p", "L", 0);
inline const auto probe_y = number("probe_y", "y_p", "L", 0);
inline const auto wave_height = number("amplitude", "a", "L", 0.01, not_negative);
inline const auto thread_width = number("thread_width", "d", "L", 4e-3);
inline const auto thread_length = number("thread_length", "L", "L", 0.3);
inline const auto thread_speed = number("thread_speed", "U", "L/s", 0.5);
inline const auto fall_height = number("fall_height", "H", "L", 0.08);

inline const auto drop_shape = choice("shape", {"ellipse", "square"});
inline const auto drop_deformation = number("deformation", "epsilon", "", 0.05, {.low = -0.5, .high = 0.5});

}  // namespace clapotis::stage5
