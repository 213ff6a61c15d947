#include "common/window/kernel_view.hpp"

#include "common/words.hpp"
#include "imgui.h"

namespace clapotis {

void toggle_kernel(WindowState& state) {
  const auto& simulation = state.session.simulation();
  const auto& w = words().window.kernel;
  auto& sight = state.sight;
  state.attempt([&] {
    if (!simulation.model().has_pairs()) throw BadInput(std::string(w.none));
    if (simulation.particles().size() == 0) throw BadInput(std::string(w.nobody));
    sight.viewpoint.kernel = !sight.viewpoint.kernel;
    if (!sight.viewpoint.chosen) sight.select_middle(simulation);
  });
}

void lay_out_kernel_tick(WindowState& state, Controls& controls) {
  const auto& simulation = state.session.simulation();
  if (!simulation.model().has_pairs()) return;
  const auto& w = words().window.kernel;
  bool shown = state.sight.viewpoint.kernel;
  const std::string label(simulation.setup().fluid ? w.label : w.contact_label);
  if (ImGui::Checkbox((label + "###kernel").c_str(), &shown)) toggle_kernel(state);
  controls.name_last("kernel");
  ImGui::SameLine();
}

}  // namespace clapotis
