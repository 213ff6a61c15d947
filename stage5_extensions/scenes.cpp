#include "stage5_extensions/scenes.hpp"

namespace clapotis::stage5 {

Stage stage() {
  // Morris, Fox & Zhu 1997: water in a gap of one millimetre.
  const Defaults gap{{"tension", "yes"}, {"slip", "no"}, {"nu", "1e-6"}, {"spacing", "2e-5"}};
  const Defaults small_waves{{"h_over_dx", "2"}, {"tank_width", "1"}, {"spacing", "0.02"}, {"alpha", "0"}};
  auto driven = gap, dragged = gap;
  driven["plate_speed"] = "0";
  dragged["driving"] = "0";
  // Honey, ten thousand times as viscous as water, in a dish.
  const Defaults honey_in_dish{{"reference_density", "1400"}, {"nu", "0.02"},        {"slip", "no"},
                               {"spacing", "0.0008"},         {"tank_width", "0.1"}, {"tank_height", "0.01"},
                               {"disturbance", "0.2"}};
  auto wave = small_waves, sway = small_waves;
  wave["tank_height"] = "1.3";
  sway["tank_height"] = "0.8";
  sway["depth"] = "0.5";
  sway["amplitude"] = "0.01";
  return {.name = "stage5_extensions",
          .title = "Stage 5 - extensions",
          .scenes = {{.name = "sloshing", .length_unit = "m", .defaults = sway, .build = sloshing},
                     {.name = "standing_wave", .length_unit = "m", .defaults = wave, .build = standing_wave},
                     {.name = "poiseuille", .length_unit = "m", .defaults = driven, .build = channel},
                     {.name = "couette", .length_unit = "m", .defaults = dragged, .build = channel},
                     {.name = "honey", .length_unit = "m", .defaults = honey_in_dish, .build = honey}}};
}

}  // namespace clapotis::stage5
