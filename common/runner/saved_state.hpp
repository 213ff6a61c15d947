#pragma once

#include <filesystem>
#include <memory>
#include <string>

#include "common/runner/options.hpp"
#include "common/simulation/simulation.hpp"

namespace clapotis {

/// A run as it stands, from which the same program goes on bit for bit.
struct SavedState {
  std::string stage, scene, integrator;
  Overrides parameters;  ///< that the scene was built from; live changes since then are in `bytes`
  double time = 0;       ///< [s]
  long steps = 0;
  std::string bytes;                ///< see Simulation::pass_state
  std::filesystem::path file = {};  ///< that it was read from
};

/// A copy of the run as it stands.
SavedState copy_state(const Stage& stage, Simulation& simulation);

/// The file: a line `Clapotis state FORMAT HEADER_BYTES STATE_BYTES`; the header, JSON (version, build,
/// vector width, stage, scene, integrator, parameters, time, steps); the bytes; the sum of all before it,
/// FNV-1a of 64 bits. Throws FileError.
void write_state(const std::filesystem::path& file, const SavedState& saved);

/// Throws FileError when the file cannot be read, is no state, cut short or damaged, or when another build,
/// version or vector width wrote it, which would not go on with the same bits; BadInput when it is of another
/// stage.
SavedState read_state(const std::filesystem::path& file, const Stage& stage);

/// The simulation that the options ask for: a new one, or one that goes on from a saved state. Then what the
/// options give besides may agree with the state, or change what may change while a scene runs; throws
/// BadInput otherwise, and FileError when the state does not fit.
std::unique_ptr<Simulation> start_simulation(const Stage& stage, const Options& options);

/// The same from a state alone, with nothing changed.
std::unique_ptr<Simulation> resume_simulation(const Stage& stage, const SavedState& saved, int threads);

}  // namespace clapotis
