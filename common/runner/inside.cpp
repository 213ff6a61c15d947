#include "common/runner/inside.hpp"

#include <algorithm>
#include <array>
#include <utility>

namespace clapotis {
namespace {

constexpr Colour blue = curve_colours[0], vermilion = curve_colours[1], green = curve_colours[2],
                 purple = curve_colours[3], orange = curve_colours[4], sky{0.337F, 0.706F, 0.914F},
                 grey{0.45F, 0.49F, 0.54F}, yellow{0.941F, 0.894F, 0.259F};

using Known = std::pair<std::string_view, Colour>;
constexpr std::array known{
    Known{"gravity", blue},
    Known{"pressure", vermilion},
    Known{"contact_spring", vermilion},
    Known{"air_drag", green},
    Known{"viscosity", green},
    Known{"artificial_viscosity", green},
    Known{"laminar_viscosity", sky},
    Known{"newtonian_viscosity", sky},
    Known{"implicit_viscosity", sky},
    Known{"surface_tension", purple},
    Known{"tensile_correction", purple},
    Known{"hand", orange},
    Known{"driving_force", orange},
    Known{"tank_motion", orange},
    Known{"walls", grey},
};
constexpr std::array all{blue, vermilion, green, purple, orange, sky, yellow, grey};

}  // namespace

Colour law_colour(std::string_view law, const std::vector<ForceArrow>& before) {
  const auto is_free = [&](Colour colour) {
    return std::ranges::find(before, colour, &ForceArrow::colour) == before.end();
  };
  const auto own = std::ranges::find(known, law, &Known::first);
  if (own != known.end() && is_free(own->second)) return own->second;
  const auto free = std::ranges::find_if(all, is_free);
  return free != all.end() ? *free : grey;
}

}  // namespace clapotis
