#include "common/runner/parameter_json.hpp"

#include <cmath>

namespace clapotis {

using Json = nlohmann::ordered_json;

Json json_value(const Parameter& p) {
  if (p.list) return p.values;
  if (!p.choices.empty() || std::isnan(p.value)) return p.text();
  if (p.integer) return static_cast<long long>(p.value);
  return p.value;
}

Json parameters_json(const Parameters& parameters) {
  Json object = Json::object();
  for (const auto& p : parameters.all())
    object[p.name] = {{"value", json_value(p)},
                      {"unit", p.unit},
                      {"origin", p.derived ? origin_of_results : name_of(p.origin)}};
  return object;
}

}  // namespace clapotis
