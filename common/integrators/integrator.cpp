#include "common/integrators/integrator.hpp"

#include "common/integrators/explicit_euler.hpp"
#include "common/integrators/rk2.hpp"
#include "common/integrators/rk4.hpp"
#include "common/integrators/symplectic_euler.hpp"
#include "common/integrators/velocity_verlet.hpp"
#include "common/simulation/errors.hpp"
#include "common/simulation/parameters.hpp"

namespace clapotis {
namespace {

template <class Scheme>
std::unique_ptr<Integrator> make() {
  return std::make_unique<Scheme>();
}

struct Entry {
  std::string name;
  std::unique_ptr<Integrator> (*make)();
};

const std::vector<Entry>& table() {
  static const std::vector<Entry> entries{{"explicit_euler", make<ExplicitEuler>},
                                          {"symplectic_euler", make<SymplecticEuler>},
                                          {"velocity_verlet", make<VelocityVerlet>},
                                          {"rk2", make<Rk2>},
                                          {"rk4", make<Rk4>}};
  return entries;
}

}  // namespace

const std::vector<std::string>& integrator_names() {
  static const auto names = [] {
    std::vector<std::string> all;
    for (const auto& entry : table()) all.push_back(entry.name);
    return all;
  }();
  return names;
}

std::unique_ptr<Integrator> make_integrator(std::string_view name) {
  for (const auto& entry : table())
    if (entry.name == name) return entry.make();
  throw BadInput(unknown_name("integrator", name, integrator_names()));
}

}  // namespace clapotis
