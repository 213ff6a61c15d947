#include "common/lesson/measure.hpp"

#include "common/runner/series.hpp"
#include "common/runner/units.hpp"

namespace clapotis {

std::optional<Measured> measure(std::string_view quantity, Simulation& simulation) {
  const auto count = [](auto number) { return Measured{static_cast<double>(number), "1"}; };
  if (quantity == "steps") return count(simulation.steps());
  if (quantity == "force_evaluations") return count(simulation.system().force_evaluations);
  if (simulation.model().has_pairs() && (quantity == "pairs_tested" || quantity == "pairs_near")) {
    const auto pairs = simulation.model().count_pairs(simulation.particles());
    return count(quantity == "pairs_near" ? pairs.neighbours : pairs.candidates);
  }
  for (const auto& own : simulation.setup().measures)
    if (own.name == quantity)
      return Measured{own.value(simulation.system()), with_length(own.unit, simulation.scene().length_unit)};
  if (quantity == "inflow" || quantity == "outflow") return std::nullopt;  // since an instant before
  for (const auto& column : series_columns())
    if (column.name == quantity && column.has_meaning(simulation)) {
      const auto unit = unit_of(column, simulation);
      return Measured{column.value(Moment(simulation)), unit.empty() ? "1" : unit};
    }
  return std::nullopt;
}

}  // namespace clapotis
