#include "common/runner/particle_table.hpp"

#include <charconv>
#include <cmath>
#include <limits>

#include "common/laws/dummy_walls.hpp"
#include "common/runner/atomic_file.hpp"
#include "common/runner/units.hpp"

namespace clapotis {
namespace {

void append(std::string& row, double value) {
  constexpr int digits_after_the_first = 16;
  char text[32];
  const auto end =
      std::to_chars(text, text + sizeof text, value, std::chars_format::scientific, digits_after_the_first);
  row += ',';
  row += std::isnan(value) ? std::string_view("nan") : std::string_view(text, end.ptr);
}

/// The particles that walls are made of, in the order of their grid, numbered from `first` on.
void write_walls(AtomicFile& table, const DummyWalls& walls, const Particles& particles, Index first) {
  std::string row;
  for (Index k = 0; k < walls.size(); ++k) {
    row = std::to_string(first + k) + ",wall";
    for (const double place : {walls.places(k, 0), walls.places(k, 1)}) append(row, place);
    for (int at_rest = 0; at_rest < 4; ++at_rest) append(row, 0);
    for (const auto& column : particles.columns()) {
      const double value = column.name == "density"    ? walls.columns.density(k)
                           : column.name == "pressure" ? walls.columns.pressure(k)
                                                       : std::numeric_limits<double>::quiet_NaN();
      append(row, value);
    }
    table.write(row += '\n');
  }
}

}  // namespace

Index first_wall_id(const Particles& particles) {
  return particles.size() > 0 ? particles.id(particles.size() - 1) + 1 : 0;
}

void write_particles(const std::filesystem::path& file, Simulation& simulation) {
  AtomicFile table(file);
  std::string row = "id,kind,x,y,vx,vy,ax,ay";
  for (const auto& column : simulation.particles().columns()) row += "," + std::string(column.name);
  table.write(row + "\n");
  simulation.look([&](const System& system) {
    const auto& p = system.particles;
    for (Index i = 0; i < p.size(); ++i) {
      row = std::to_string(p.id(i)) + "," + std::string(p.kind);
      for (const auto* vectors : {&p.position, &p.velocity, &p.acceleration})
        for (const int axis : {0, 1}) append(row, (*vectors)(i, axis));
      for (const auto& column : p.columns()) append(row, column.values(i));
      table.write(row += '\n');
    }
    if (const auto* walls = system.model.wall_particles()) write_walls(table, *walls, p, first_wall_id(p));
  });
  table.commit();
}

std::map<std::string, std::string> particle_units(const Simulation& simulation) {
  const auto& length = simulation.scene().length_unit;
  std::map<std::string, std::string> units{
      {"id", "1"},           {"kind", ""},          {"x", length},           {"y", length},
      {"vx", length + "/s"}, {"vy", length + "/s"}, {"ax", length + "/s^2"}, {"ay", length + "/s^2"}};
  for (const auto& column : simulation.particles().columns())
    units[std::string(column.name)] = with_length(column.unit, length);
  return units;
}

}  // namespace clapotis
