#pragma once

#include <filesystem>
#include <map>
#include <string>

#include "common/runner/run_folder.hpp"
#include "common/simulation/simulation.hpp"

namespace clapotis {

/// Writes the particles as they stand as VTK's unstructured grid (.vtu): one vertex each, those of the walls
/// behind the others, all arrays in base64 at full precision. The arrays are `id`, `kind` (0 a particle, 1
/// one of a wall), `velocity`, `acceleration`, then the columns of the scene as in final.csv; each carries
/// its unit (VTK's UNITS_LABEL), and the file its time (TimeValue).
void write_vtu(const std::filesystem::path& file, Simulation& simulation);

/// The unit of each array.
std::map<std::string, std::string> vtk_units(const Simulation& simulation);

/// vtk/NNNN.vtu, and vtk.pvd that lists them with their times: what ParaView opens. The list is written
/// again about once a second, so that a killed run has one.
class VtkFiles {
 public:
  explicit VtkFiles(const RunFolder& folder) : folder_(folder) {}
  void add(Simulation& simulation);
  void close();

 private:
  const RunFolder& folder_;
  std::string entries_;
  long count_ = 0;
  double last_list_ = 0;  ///< when it was written [s]
};

}  // namespace clapotis
