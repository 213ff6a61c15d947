#include "common/laws/air_drag.hpp"
#include "common/laws/contact_spring.hpp"
#include "common/laws/gravity.hpp"
#include "common/laws/walls.hpp"
#include "common/neighbours/cell_grid.hpp"
#include "report/cloud_with.hpp"
#include "report/packed_cloud.hpp"
#include "report/studies/one_law_more.hpp"

namespace clapotis::studies {
namespace {

template <class... Laws>
using Alone = FusedModel<NoPairs, UniformMass, Laws...>;
template <class... Laws>
using Touching = FusedModel<CellGrid, UniformMass, ContactSpring, Laws...>;

/// Ten thousand discs in a pack, which a tiny step leaves as it is.
template <class Model>
OneLawMore discs(const char* law, bool masses = false) {
  return {law, [=] {
            return packed_cloud(cloud_with<Model>("discs", masses), 10000, 1, {{"dt", {"1e-9"}}});
          }};
}

}  // namespace

std::vector<Priced> priced_discs() {
  using Heavy = Alone<Gravity>;
  using HeavyInAir = Alone<Gravity, AirDrag>;
  using HeavyInBox = Alone<Gravity, BoxWalls>;
  using HeavyOnes = FusedModel<NoPairs, StoredMass, Gravity, AirDrag>;
  using HeavyAndTouching = FusedModel<CellGrid, UniformMass, Gravity, ContactSpring>;
  return {{.scene = "discs that pass each other",
           .itself = discs<Heavy>("gravity"),
           .more = {discs<HeavyInAir>("air drag"), discs<HeavyInBox>("walls"),
                    discs<HeavyOnes>("drag and masses of their own", true),
                    discs<HeavyAndTouching>("contact springs")}},
          {.scene = "discs that touch",
           .itself = discs<Touching<>>("contact springs"),
           .more = {discs<Touching<Gravity>>("gravity"), discs<Touching<AirDrag>>("air drag"),
                    discs<Touching<SupportingWalls>>("walls"),
                    discs<FusedModel<CellGrid, StoredMass, ContactSpring>>("masses of their own", true)}}};
}

}  // namespace clapotis::studies
