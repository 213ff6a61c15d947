#include "common/runner/particle_table.hpp"

#include <charconv>
#include <cmath>

#include "common/runner/atomic_file.hpp"
#include "common/runner/series.hpp"

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

}  // namespace

void write_particles(const std::filesystem::path& file, Simulation& simulation) {
  AtomicFile table(file);
  std::string row = "id,kind,x,y,vx,vy,ax,ay";
  for (const auto& column : simulation.particles().columns()) row += "," + std::string(column.name);
  table.write(row + "\n");
  simulation.look([&](const System& system) {
    const auto& p = system.particles;
    for (Index i = 0; i < p.size(); ++i) {
      row = std::to_string(i) + "," + std::string(p.kind);
      for (const auto* vectors : {&p.position, &p.velocity, &p.acceleration})
        for (const int axis : {0, 1}) append(row, (*vectors)(i, axis));
      for (const auto& column : p.columns()) append(row, column.values(i));
      table.write(row += '\n');
    }
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
