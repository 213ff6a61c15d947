#pragma once

#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "common/simulation/system.hpp"

namespace clapotis {

class Parameters;

/// A scheme that advances a system by one step. On entry the acceleration belongs to the state
/// (System::current). An integrator keeps its scratch columns between steps, so that a step allocates
/// nothing.
class Integrator {
 public:
  virtual ~Integrator() = default;
  virtual void step(System& system, double dt) = 0;
  /// Whether the acceleration left by a step serves as the first one of the next.
  [[nodiscard]] virtual bool leaves_acceleration() const { return false; }
  /// Whether it cuts a step that is too long for it, so that limits of stability do not bind it.
  [[nodiscard]] virtual bool controls_error() const { return false; }
  /// Reads its parameters, again after one of them changed.
  virtual void read(Parameters& /*parameters*/) {}
};

/// What moves: particles alone, or those of a liquid, whose density is advanced with them.
enum class Matter { particles, liquid };

/// explicit_euler, symplectic_euler, velocity_verlet (the default), rk2, rk4, and for particles alone
/// bogacki_shampine.
const std::vector<std::string>& integrator_names(Matter matter);
inline constexpr std::string_view default_integrator = "velocity_verlet";

/// Throws BadInput, with the names there are, for one that is not in the list.
std::unique_ptr<Integrator> make_integrator(std::string_view name, Matter matter);

}  // namespace clapotis
