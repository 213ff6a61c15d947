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
inline const auto wave_height = number("amplitude", "a", "L", 0.01, not_negative);

inline const auto drop_shape = choice("shape", {"ellipse", "square"});
inline const auto drop_deformation = number("deformation", "epsilon", "", 0.05, {.low = -0.5, .high = 0.5});

}  // namespace clapotis::stage5
