#pragma once

#include <filesystem>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "common/runner/atomic_file.hpp"
#include "common/simulation/simulation.hpp"

namespace clapotis {

/// What a row of the series is computed from: the simulation as it stands, its energies counted once.
struct Moment {
  explicit Moment(Simulation& s) : simulation(s), energy(s.energy()) {}
  Simulation& simulation;
  Energy energy;
  struct Passed {
    double time = 0;
    long entered = 0, left = 0;
  };
  Passed before = {};  ///< at the last row: flows are what passed since then
};

/// A column of series.csv. In `unit`, L stands for the scene's unit of length; a pure number has "1";
/// "energy", "momentum" and "error" are those of the scene.
struct SeriesColumn {
  std::string_view name, unit;
  double (*value)(const Moment&);
  bool (*has_meaning)(const Simulation&);  ///< a column without meaning in the scene is absent
};

/// All columns there are: drives the header, the units in run.json and the documentation.
std::span<const SeriesColumn> series_columns();
std::string unit_of(const SeriesColumn& column, const Simulation& simulation);

/// series.csv of one run. What was computed so far reaches the disk about once a second, as series.csv.part.
class Series {
 public:
  Series(const std::filesystem::path& file, const Simulation& simulation);
  void add(Moment moment);
  void close() { file_.commit(); }

  [[nodiscard]] const std::vector<SeriesColumn>& columns() const { return columns_; }

 private:
  AtomicFile file_;
  std::vector<SeriesColumn> columns_;
  Moment::Passed last_row_;
  double last_flush_ = 0;
};

}  // namespace clapotis
