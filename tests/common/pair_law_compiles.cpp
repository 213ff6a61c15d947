// Compiled by CTest alone, with READS_VELOCITY and SEARCH set, to see what the compiler says.
#include "common/laws/law.hpp"
#include "common/neighbours/all_pairs.hpp"
#include "common/simulation/fused_model.hpp"

namespace clapotis {

/// Friction between neighbours, as a student might write it.
struct Friction {
  static constexpr std::string_view name = "friction";
  static constexpr bool reads_velocity = READS_VELOCITY;

  static Friction from(Parameters&) { return {}; }
  Vec<Pack> pair(const auto& p, auto i, auto j, const Encounter&) const {
    const auto vi = p.velocity(i);
    const auto vj = p.velocity(j);
    return {vj.x - vi.x, vj.y - vi.y};
  }
  [[nodiscard]] double support() const { return 1; }
};
static_assert(Law<Friction> && ActsOnPair<Friction>);

template class FusedModel<SEARCH, UniformMass, Friction>;

}  // namespace clapotis
