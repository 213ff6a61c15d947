#pragma once

#include <filesystem>
#include <map>
#include <string>

#include "common/simulation/simulation.hpp"

namespace clapotis {

/// Writes the particles as they stand, one row each, sorted by id: id,kind,x,y,vx,vy,ax,ay, then the columns
/// of the scene. 17 significant digits, which read back as the same bits. The accelerations are the sum of
/// the laws at the written positions and velocities. `kind` is "disc" for every particle of stages 1 to 3,
/// "fluid" from stage 4 on; at the end come the particles of the walls, "wall", at rest, their ids following
/// on.
void write_particles(const std::filesystem::path& file, Simulation& simulation);

/// The id that the first particle of the walls has in files: they follow on the last of the others.
Index first_wall_id(const Particles& particles);

/// The unit of each of its columns.
std::map<std::string, std::string> particle_units(const Simulation& simulation);

}  // namespace clapotis
