#include "common/runner/vtk_files.hpp"

#include <bit>
#include <cmath>
#include <cstdint>
#include <limits>
#include <vector>

#include "common/laws/dummy_walls.hpp"
#include "common/runner/atomic_file.hpp"
#include "common/runner/particle_table.hpp"
#include "common/runner/stopwatch.hpp"
#include "common/runner/units.hpp"
#include "common/simulation/parameters.hpp"

namespace clapotis {
namespace {

constexpr double seconds_between_lists = 1;
constexpr std::string_view byte_order =
    std::endian::native == std::endian::little ? "LittleEndian" : "BigEndian";

/// RFC 4648.
std::string base64(std::string_view bytes) {
  constexpr std::string_view letters = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  std::string text;
  text.reserve((bytes.size() + 2) / 3 * 4);
  for (std::size_t k = 0; k < bytes.size(); k += 3) {
    const auto byte = [&](std::size_t at) {
      return at < bytes.size() ? static_cast<unsigned char>(bytes[at]) : 0U;
    };
    const unsigned three = byte(k) << 16U | byte(k + 1) << 8U | byte(k + 2);
    for (const unsigned shift : {18U, 12U, 6U, 0U}) text += letters[three >> shift & 63U];
  }
  if (bytes.size() % 3 > 0) text.replace(text.size() - (3 - bytes.size() % 3), 3, 3 - bytes.size() % 3, '=');
  return text;
}

template <class T>
constexpr std::string_view type_of = std::is_same_v<T, double>         ? "Float64"
                                     : std::is_same_v<T, std::int64_t> ? "Int64"
                                                                       : "UInt8";

std::string escaped(std::string_view text) {
  std::string safe;
  for (const char c : text) safe += c == '<' ? "&lt;" : c == '&' ? "&amp;" : std::string(1, c);
  return safe;
}

/// One array, its size in bytes in front of its numbers.
template <class T>
void write_array(AtomicFile& file, std::string_view name, int components, const std::vector<T>& numbers,
                 std::string_view unit = {}) {
  const std::uint64_t size = numbers.size() * sizeof(T);
  std::string bytes(reinterpret_cast<const char*>(&size), sizeof size);
  bytes.append(reinterpret_cast<const char*>(numbers.data()), size);
  file.write(fmt::format("<DataArray type=\"{}\" Name=\"{}\" NumberOfComponents=\"{}\" format=\"binary\">\n",
                         type_of<T>, escaped(name), components));
  file.write(base64(bytes));
  if (!unit.empty())  // behind the numbers, which VTK looks for at once
    file.write(
        fmt::format("\n<InformationKey name=\"UNITS_LABEL\" location=\"vtkDataArray\">{}</InformationKey>",
                    escaped(unit)));
  file.write("\n</DataArray>\n");
}

/// VTK knows three components only.
std::vector<double> triples(const Vectors& vectors, Index walls) {
  std::vector<double> all;
  for (Index i = 0; i < vectors.rows(); ++i) all.insert(all.end(), {vectors(i, 0), vectors(i, 1), 0.0});
  all.resize(static_cast<std::size_t>(3 * (vectors.rows() + walls)), 0);
  return all;
}

std::vector<double> with_walls(const Particles::View& column, const DummyWalls* walls) {
  std::vector<double> all(column.values.begin(), column.values.end());
  for (Index k = 0; walls != nullptr && k < walls->size(); ++k)
    all.push_back(column.name == "density"    ? walls->columns.density(k)
                  : column.name == "pressure" ? walls->columns.pressure(k)
                                              : std::numeric_limits<double>::quiet_NaN());
  return all;
}

void write_points(AtomicFile& file, const Particles& particles, const DummyWalls* walls) {
  auto places = triples(particles.position, 0);
  for (Index k = 0; walls != nullptr && k < walls->size(); ++k)
    places.insert(places.end(), {walls->places(k, 0), walls->places(k, 1), 0.0});
  file.write("<Points>\n");
  write_array(file, "Points", 3, places);
  file.write("</Points>\n");
}

/// Each particle is a cell of one point.
void write_cells(AtomicFile& file, Index count) {
  constexpr std::uint8_t vertex = 1;  // VTK_VERTEX
  std::vector<std::int64_t> points, ends;
  for (Index i = 0; i < count; ++i) {
    points.push_back(i);
    ends.push_back(i + 1);
  }
  file.write("<Cells>\n");
  write_array(file, "connectivity", 1, points);
  write_array(file, "offsets", 1, ends);
  write_array(file, "types", 1, std::vector<std::uint8_t>(static_cast<std::size_t>(count), vertex));
  file.write("</Cells>\n");
}

void write_columns(AtomicFile& file, const Simulation& simulation, const Particles& particles,
                   const DummyWalls* walls) {
  const Index n = particles.size(), of_walls = walls != nullptr ? walls->size() : 0;
  const auto units = vtk_units(simulation);
  std::vector<std::int64_t> ids;
  for (Index i = 0; i < n; ++i) ids.push_back(particles.id(i));
  for (Index k = 0; k < of_walls; ++k) ids.push_back(first_wall_id(particles) + k);
  std::vector<std::uint8_t> kinds(static_cast<std::size_t>(n), 0);
  kinds.resize(ids.size(), 1);
  file.write("<PointData Scalars=\"kind\" Vectors=\"velocity\">\n");
  write_array(file, "id", 1, ids);
  write_array(file, "kind", 1, kinds);
  write_array(file, "velocity", 3, triples(particles.velocity, of_walls), units.at("velocity"));
  write_array(file, "acceleration", 3, triples(particles.acceleration, of_walls), units.at("acceleration"));
  for (const auto& column : particles.columns())
    write_array(file, column.name, 1, with_walls(column, walls), units.at(std::string(column.name)));
  file.write("</PointData>\n");
}

}  // namespace

void write_vtu(const std::filesystem::path& path, Simulation& simulation) {
  AtomicFile file(path);
  simulation.look([&](const System& system) {
    const auto& particles = system.particles;
    const auto* walls = system.model.wall_particles();
    const Index count = particles.size() + (walls != nullptr ? walls->size() : 0);
    file.write(
        fmt::format("<?xml version=\"1.0\"?>\n<VTKFile type=\"UnstructuredGrid\" version=\"1.0\" "
                    "byte_order=\"{}\" header_type=\"UInt64\">\n<UnstructuredGrid>\n<FieldData>\n"
                    "<DataArray type=\"Float64\" Name=\"TimeValue\" NumberOfTuples=\"1\" format=\"ascii\">"
                    "{}</DataArray>\n</FieldData>\n<Piece NumberOfPoints=\"{}\" NumberOfCells=\"{}\">\n",
                    byte_order, to_text(system.time), count, count));
    write_columns(file, simulation, particles, walls);
    write_points(file, particles, walls);
    write_cells(file, count);
    file.write("</Piece>\n</UnstructuredGrid>\n</VTKFile>\n");
  });
  file.commit();
}

std::map<std::string, std::string> vtk_units(const Simulation& simulation) {
  auto units = particle_units(simulation);
  for (const auto* component : {"x", "y", "vx", "vy", "ax", "ay"}) units.erase(component);
  const auto& length = simulation.scene().length_unit;
  units["Points"] = length;
  units["velocity"] = length + "/s";
  units["acceleration"] = length + "/s^2";
  units["kind"] = "0 a particle, 1 one of a wall";
  return units;
}

void VtkFiles::add(Simulation& simulation) {
  const auto file = folder_.numbered("vtk", count_++, ".vtu");
  write_vtu(file, simulation);
  entries_ += fmt::format("<DataSet timestep=\"{}\" part=\"0\" file=\"vtk/{}\"/>\n",
                          to_text(simulation.time()), file.filename().string());
  if (wall_seconds() - last_list_ > seconds_between_lists) close();
}

void VtkFiles::close() {
  write_file(folder_.file("vtk.pvd"),
             fmt::format("<?xml version=\"1.0\"?>\n<VTKFile type=\"Collection\" version=\"0.1\" "
                         "byte_order=\"{}\">\n<Collection>\n{}</Collection>\n</VTKFile>\n",
                         byte_order, entries_));
  last_list_ = wall_seconds();
}

}  // namespace clapotis
