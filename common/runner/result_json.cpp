#include "common/runner/result_json.hpp"

namespace clapotis {

using Json = nlohmann::ordered_json;

Json energy_json(const Energy& e) {
  return {{"kinetic", or_null(e.kinetic)},
          {"potential", or_null(e.potential)},
          {"elastic", or_null(e.elastic)},
          {"internal", or_null(e.internal)},
          {"mechanical", or_null(e.mechanical())},
          {"dissipated", or_null(e.dissipated)},
          {"total", or_null(e.total())}};
}

Json reference_json(const Simulation& simulation, double largest_error) {
  const auto& reference = simulation.setup().reference;
  if (!reference) return nullptr;
  return {{"name", reference->name},
          {"measure", reference->measure},
          {"error", or_null(simulation.error())},
          {"largest_error", or_null(largest_error)},
          {"unit", reference->unit},
          {"source", reference->source}};
}

}  // namespace clapotis
