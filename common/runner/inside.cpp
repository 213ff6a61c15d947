#include "common/runner/inside.hpp"

#include <algorithm>
#include <array>
#include <utility>

#include "common/runner/ink.hpp"

namespace clapotis {
namespace {

/// The colours that forces may have, in the palette in use.
enum Hue : std::size_t { blue, vermilion, green, purple, orange, sky, yellow, grey };
constexpr std::array all{blue, vermilion, green, purple, orange, sky, yellow, grey};

Colour of(Hue hue) {
  const auto& p = ink::palette();
  return hue < sky ? p.curves[hue] : p.spare[hue - sky];
}

using Known = std::pair<std::string_view, Hue>;
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

}  // namespace

Colour law_colour(std::string_view law, const std::vector<ForceArrow>& before) {
  const auto is_free = [&](Hue hue) {
    return std::ranges::find(before, of(hue), &ForceArrow::colour) == before.end();
  };
  const auto own = std::ranges::find(known, law, &Known::first);
  if (own != known.end() && is_free(own->second)) return of(own->second);
  const auto free = std::ranges::find_if(all, is_free);
  return of(free != all.end() ? *free : grey);
}

}  // namespace clapotis
