#include "common/integrators/integrator.hpp"

#include "common/integrators/bogacki_shampine.hpp"
#include "common/integrators/explicit_euler.hpp"
#include "common/integrators/rk2.hpp"
#include "common/integrators/rk4.hpp"
#include "common/integrators/symplectic_euler.hpp"
#include "common/integrators/velocity_verlet.hpp"
#include "common/simulation/errors.hpp"
#include "common/simulation/parameters.hpp"
#include "common/words.hpp"

namespace clapotis {
namespace {

template <class Scheme>
std::unique_ptr<Integrator> make() {
  return std::make_unique<Scheme>();
}

struct Entry {
  std::string name;
  std::unique_ptr<Integrator> (*make)();
  bool advances_density = true;
};

const std::vector<Entry>& table() {
  static const std::vector<Entry> entries{{"explicit_euler", make<ExplicitEuler>},
                                          {"symplectic_euler", make<SymplecticEuler>},
                                          {"velocity_verlet", make<VelocityVerlet>},
                                          {"rk2", make<Rk2>},
                                          {"rk4", make<Rk4>},
                                          {"bogacki_shampine", make<BogackiShampine>, false}};
  return entries;
}

std::vector<std::string> names(Matter matter) {
  std::vector<std::string> all;
  for (const auto& entry : table())
    if (matter == Matter::particles || entry.advances_density) all.push_back(entry.name);
  return all;
}

}  // namespace

const std::vector<std::string>& integrator_names(Matter matter) {
  static const auto of_particles = names(Matter::particles), of_liquid = names(Matter::liquid);
  return matter == Matter::particles ? of_particles : of_liquid;
}

std::unique_ptr<Integrator> make_integrator(std::string_view name, Matter matter) {
  for (const auto& entry : table()) {
    if (entry.name != name) continue;
    if (matter == Matter::particles || entry.advances_density) return entry.make();
    throw BadInput(say(words().integrator_of_particles, fmt::arg("name", name),
                       fmt::arg("known", joined(integrator_names(matter)))));
  }
  throw BadInput(unknown_name("integrator", name, integrator_names(matter)));
}

}  // namespace clapotis
