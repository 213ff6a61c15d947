#include "common/runner/series.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "common/runner/stopwatch.hpp"
#include "common/runner/units.hpp"

namespace clapotis {
namespace {

constexpr double seconds_between_flushes = 1;

constexpr bool always(const Simulation&) { return true; }
bool is_fluid(const Simulation& s) { return s.setup().fluid.has_value(); }
bool has_springs(const Simulation& s) { return s.model().has_pairs() && !is_fluid(s); }
bool has_reference(const Simulation& s) { return s.setup().reference.has_value(); }
bool has_open_ends(const Simulation& s) { return s.model().has_open_ends(); }
bool has_sound(const Simulation& s) { return s.sound_speed() > 0 && s.smoothing_length() > 0; }

double mass_of(const Moment& m, long particles) {
  return static_cast<double>(particles) * m.simulation.particles().uniform_mass;
}
/// Since the last row.
double flow_of(const Moment& m, long particles) {
  const double time = m.simulation.time() - m.before.time;
  return time > 0 ? mass_of(m, particles) / time : 0;
}

constexpr std::array all_columns{
    SeriesColumn{"t", "s", [](const Moment& m) { return m.simulation.time(); }, always},
    SeriesColumn{"dt", "s", [](const Moment& m) { return m.simulation.dt(); }, always},
    SeriesColumn{"step", "1", [](const Moment& m) { return static_cast<double>(m.simulation.steps()); },
                 always},
    SeriesColumn{"particles", "1",
                 [](const Moment& m) { return static_cast<double>(m.simulation.particles().size()); },
                 always},
    SeriesColumn{"kinetic_energy", "energy", [](const Moment& m) { return m.energy.kinetic; }, always},
    SeriesColumn{"potential_energy", "energy", [](const Moment& m) { return m.energy.potential; }, always},
    SeriesColumn{"elastic_energy", "energy", [](const Moment& m) { return m.energy.elastic; }, has_springs},
    SeriesColumn{"internal_energy", "energy", [](const Moment& m) { return m.energy.internal; }, is_fluid},
    SeriesColumn{"mechanical_energy", "energy", [](const Moment& m) { return m.energy.mechanical(); },
                 always},
    SeriesColumn{"dissipated_energy", "energy", [](const Moment& m) { return m.energy.dissipated; }, always},
    SeriesColumn{"total_energy", "energy", [](const Moment& m) { return m.energy.total(); }, always},
    SeriesColumn{"momentum_x", "momentum",
                 [](const Moment& m) { return momentum(m.simulation.particles()).x; }, always},
    SeriesColumn{"momentum_y", "momentum",
                 [](const Moment& m) { return momentum(m.simulation.particles()).y; }, always},
    SeriesColumn{"centre_x", "L", [](const Moment& m) { return centre_of_mass(m.simulation.particles()).x; },
                 always},
    SeriesColumn{"centre_y", "L", [](const Moment& m) { return centre_of_mass(m.simulation.particles()).y; },
                 always},
    SeriesColumn{"mass_in", "kg/L", [](const Moment& m) { return mass_of(m, m.simulation.system().entered); },
                 has_open_ends},
    SeriesColumn{"mass_out", "kg/L", [](const Moment& m) { return mass_of(m, m.simulation.system().left); },
                 has_open_ends},
    SeriesColumn{"inflow", "kg/(L s)",
                 [](const Moment& m) { return flow_of(m, m.simulation.system().entered - m.before.entered); },
                 has_open_ends},
    SeriesColumn{"outflow", "kg/(L s)",
                 [](const Moment& m) { return flow_of(m, m.simulation.system().left - m.before.left); },
                 has_open_ends},
    SeriesColumn{"max_speed", "L/s", [](const Moment& m) { return max_speed(m.simulation.particles()); },
                 always},
    SeriesColumn{
        "density_error", "1",
        [](const Moment& m) { return density_error(m.simulation.particles(), *m.simulation.setup().fluid); },
        is_fluid},
    SeriesColumn{"cfl", "1",
                 [](const Moment& m) {
                   return m.simulation.dt() * m.simulation.sound_speed() / m.simulation.smoothing_length();
                 },
                 has_sound},
    SeriesColumn{"error", "error", [](const Moment& m) { return m.simulation.error(); }, has_reference},
};

}  // namespace

std::span<const SeriesColumn> series_columns() { return all_columns; }

std::string unit_of(const SeriesColumn& column, const Simulation& simulation) {
  if (column.unit == "energy") return energy_unit(simulation);
  if (column.unit == "momentum") return momentum_unit(simulation);
  if (column.unit == "error") return simulation.setup().reference->unit;
  return with_length(column.unit, simulation.scene().length_unit);
}

Series::Series(const std::filesystem::path& file, const Simulation& simulation)
    : file_(file, Unfinished::keep), last_flush_(wall_seconds()) {
  for (const auto& column : all_columns)
    if (column.has_meaning(simulation)) columns_.push_back(column);
  std::string header;
  for (const auto& column : columns_) {
    if (!header.empty()) header += ',';
    header += column.name;
  }
  for (const auto& measure : simulation.setup().measures) header += "," + measure.name;
  file_.write(header += '\n');
}

void Series::add(Moment moment) {
  const auto& system = moment.simulation.system();
  moment.before = std::exchange(last_row_, {system.time, system.entered, system.left});
  std::string row;
  for (const auto& column : columns_) {
    const double value = column.value(moment);
    if (!row.empty()) row += ',';
    row += std::isnan(value) ? "nan" : to_text(value);
  }
  const auto& simulation = moment.simulation;
  for (const auto& measure : simulation.setup().measures) {
    const double value = measure.value(simulation.system());
    row += std::isnan(value) ? ",nan" : "," + to_text(value);
  }
  file_.write(row += '\n');
  if (wall_seconds() - last_flush_ < seconds_between_flushes) return;
  file_.flush();
  last_flush_ = wall_seconds();
}

}  // namespace clapotis
