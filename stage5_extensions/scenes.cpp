#include "stage5_extensions/scenes.hpp"

namespace clapotis::stage5 {
namespace {

/// `beside`: what a comparison of the scene with itself begins with.
Scene in_metres(std::string name, Setup (*build)(Parameters&), Defaults defaults,
                std::pair<std::string, std::string> beside, std::vector<Preset> presets = {}) {
  return {.name = std::move(name),
          .length_unit = "m",
          .defaults = std::move(defaults),
          .build = build,
          .presets = std::move(presets),
          .beside = std::move(beside)};
}

/// The one, and where both have an entry, that of the other.
Defaults with(Defaults more, const Defaults& common) {
  more.insert(common.begin(), common.end());
  return more;
}

const Defaults small_waves{{"h_over_dx", "2"}, {"tank_width", "1"}, {"spacing", "0.02"}, {"alpha", "0"}};
const Defaults moved_tank{{"h_over_dx", "2.5"}, {"tank_width", "1"},   {"tank_height", "0.8"},
                          {"depth", "0.5"},     {"spacing", "0.0125"}, {"alpha", "0"}};
// Morris, Fox & Zhu 1997: water in a gap of one millimetre.
const Defaults gap{{"tension", "yes"}, {"slip", "no"}, {"nu", "1e-6"}, {"spacing", "2e-5"}};
// Without diffusion of density, and with a wide kernel: see surface_tension.hpp.
const Defaults small_drop{{"tension", "yes"}, {"h_over_dx", "3"},  {"delta", "0"},
                          {"radius", "1e-3"}, {"spacing", "4e-5"}, {"nu", "1e-5"}};

}  // namespace

Stage stage() {
  return {
      .name = "stage5_extensions",
      .title = "Stage 5 - extensions",
      .scenes = {
          in_metres(
              "sloshing", sloshing, with({{"amplitude", "0.005"}}, moved_tank), {"spacing", "0.025"},
              {{"resonance", {{"period", "1.18"}, {"amplitude", "0.02"}}},
               {"shallow", {{"depth", "0.1"}, {"period", "2"}, {"amplitude", "0.03"}, {"spacing", "0.01"}}}}),
          in_metres("rolling", sloshing, with({{"angle", "1"}}, moved_tank), {"spacing", "0.025"}),
          in_metres("standing_wave", standing_wave, with({{"tank_height", "1.3"}}, small_waves),
                    {"nu", "0.03"}, {{"oil", {{"nu", "0.03"}}}, {"high", {{"amplitude", "0.1"}}}}),
          in_metres("jet", jet, {{"spacing", "0.005"}, {"h_over_dx", "2"}}, {"spacing", "0.01"},
                    {{"coarse", {{"spacing", "0.01"}}},
                     {"narrow", {{"jet_width", "0.05"}, {"spacing", "0.0025"}}}}),
          in_metres("channel", open_channel,
                    {{"spacing", "5e-4"}, {"slip", "no"}, {"driving", "1"}, {"h_over_dx", "2"}},
                    {"nu", "1e-3"}),
          in_metres("draining", draining,
                    {{"spacing", "0.01"}, {"tank_width", "1"}, {"tank_height", "0.8"}, {"depth", "0.6"}},
                    {"spacing", "0.02"}),
          in_metres("poiseuille", channel, with({{"plate_speed", "0"}}, gap), {"viscous_step", "implicit"}),
          in_metres("couette", channel, with({{"driving", "0"}}, gap), {"viscous_step", "implicit"}),
          // ten thousand times as viscous as water, in a dish
          in_metres("honey", honey,
                    {{"reference_density", "1400"},
                     {"nu", "0.02"},
                     {"slip", "no"},
                     {"spacing", "0.0008"},
                     {"tank_width", "0.1"},
                     {"tank_height", "0.01"},
                     {"disturbance", "0.2"}},
                    {"nu", "0.001"}),
          in_metres("capillary_drop", capillary_drop, small_drop, {"sigma", "0.02"}),
          in_metres("sessile_drop", sessile_drop, with({{"nu", "5e-5"}}, small_drop),
                    {"contact_angle", "60"}),
          in_metres("sandbox", sandbox,
                    {{"spacing", "0.02"}, {"tank_width", "2.4"}, {"tank_height", "1.4"}, {"depth", "0.5"}},
                    {"alpha", "0.5"}, {{"moon", {{"gravity", "1.62"}}}, {"thick", {{"alpha", "0.5"}}}})}};
}

}  // namespace clapotis::stage5
