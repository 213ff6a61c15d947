#include "common/simulation/scene.hpp"

#include "common/simulation/errors.hpp"

namespace clapotis {

const Scene& Stage::scene(std::string_view wanted) const& {
  if (wanted.empty()) return scenes.front();
  std::vector<std::string> names;
  for (const auto& scene : scenes) {
    if (scene.name == wanted) return scene;
    names.push_back(scene.name);
  }
  throw BadInput(unknown_name("scene", wanted, names));
}

Overrides Scene::preset(std::string_view wanted, Origin origin) const {
  std::vector<std::string> names;
  for (const auto& preset : presets) {
    names.push_back(preset.name);
    if (preset.name != wanted) continue;
    Overrides values;
    for (const auto& [parameter, text] : preset.values) values.emplace(parameter, Override{text, origin});
    return values;
  }
  throw BadInput(unknown_name("preset", wanted, names));
}

Matter Stage::matter() const {
  Parameters p(scenes.front().length_unit, scenes.front().defaults, {});
  return scenes.front().build(p).matter();
}

}  // namespace clapotis
