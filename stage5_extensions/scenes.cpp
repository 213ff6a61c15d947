#include "stage5_extensions/scenes.hpp"

namespace clapotis::stage5 {

Stage stage() {
  // Morris, Fox & Zhu 1997: water in a gap of one millimetre.
  const Defaults gap{{"tension", "yes"}, {"slip", "no"}, {"nu", "1e-6"}, {"spacing", "2e-5"}};
  const Defaults small_waves{{"h_over_dx", "2"}, {"tank_width", "1"}, {"spacing", "0.02"}, {"alpha", "0"}};
  auto wave = small_waves, sway = small_waves;
  wave["tank_height"] = "1.3";
  sway["tank_height"] = "0.8";
  sway["depth"] = "0.5";
  sway["amplitude"] = "0.01";
  // Without diffusion of density, and with a wide kernel: see surface_tension.hpp.
  const Defaults drop{{"tension", "yes"}, {"h_over_dx", "3"},  {"delta", "0"},
                      {"radius", "1e-3"}, {"spacing", "4e-5"}, {"nu", "1e-5"}};
  auto on_plate = drop;
  on_plate["nu"] = "5e-5";
  return {
      .name = "stage5_extensions",
      .title = "Stage 5 - extensions",
      .scenes = {{.name = "sloshing", .length_unit = "m", .defaults = sway, .build = sloshing},
                 {.name = "standing_wave", .length_unit = "m", .defaults = wave, .build = standing_wave},
                 {.name = "poiseuille", .length_unit = "m", .defaults = gap, .build = poiseuille},
                 {.name = "couette", .length_unit = "m", .defaults = gap, .build = couette},
                 {.name = "capillary_drop", .length_unit = "m", .defaults = drop, .build = capillary_drop},
                 {.name = "sessile_drop", .length_unit = "m", .defaults = on_plate, .build = sessile_drop}}};
}

}  // namespace clapotis::stage5
