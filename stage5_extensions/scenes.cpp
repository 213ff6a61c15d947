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
  return {
      .name = "stage5_extensions",
      .title = "Stage 5 - extensions",
      .scenes = {
          {.name = "sloshing", .length_unit = "m", .defaults = sway, .build = sloshing},
          {.name = "standing_wave", .length_unit = "m", .defaults = wave, .build = standing_wave},
          {.name = "jet",
           .length_unit = "m",
           .defaults = {{"spacing", "0.005"}, {"h_over_dx", "2"}},
           .build = jet},
          {.name = "channel",
           .length_unit = "m",
           .defaults = {{"spacing", "5e-4"}, {"slip", "no"}, {"driving", "1"}, {"h_over_dx", "2"}},
           .build = channel},
          {.name = "draining",
           .length_unit = "m",
           .defaults = {{"spacing", "0.01"}, {"tank_width", "1"}, {"tank_height", "0.8"}, {"depth", "0.6"}},
           .build = draining},
          {.name = "sandbox",
           .length_unit = "m",
           .defaults = {{"spacing", "0.02"}, {"tank_width", "2.4"}, {"tank_height", "1.4"}, {"depth", "0.5"}},
           .build = sandbox},
          {.name = "poiseuille", .length_unit = "m", .defaults = gap, .build = poiseuille},
          {.name = "couette", .length_unit = "m", .defaults = gap, .build = couette}}};
}

}  // namespace clapotis::stage5
