#pragma once

#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "common/simulation/system.hpp"

namespace clapotis {

/// A scheme that advances a system by one step. On entry the acceleration belongs to the state
/// (System::current). An integrator keeps its scratch columns between steps, so that a step allocates
/// nothing.
class Integrator {
 public:
  virtual ~Integrator() = default;
  virtual void step(System& system, double dt) = 0;
  /// Whether the acceleration left by a step serves as the first one of the next.
  [[nodiscard]] virtual bool leaves_acceleration() const { return false; }
};

/// explicit_euler, symplectic_euler, velocity_verlet (the default), rk2, rk4.
const std::vector<std::string>& integrator_names();
inline constexpr std::string_view default_integrator = "velocity_verlet";

/// Throws BadInput, with the nearest name, for a name that is not in the list.
std::unique_ptr<Integrator> make_integrator(std::string_view name);

}  // namespace clapotis
