#include <malloc.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <memory>
#include <numeric>

#include "common/measures/energy.hpp"
#include "common/runner/machine.hpp"
#include "common/simulation/errors.hpp"
#include "report/studies/measured.hpp"
#include "report/studies/pressed_row.hpp"
#include "report/studies/studies.hpp"

namespace clapotis::studies {
namespace {

constexpr long full_steps = 1000000, quick_steps = 20000, samples = 200, looks = 50;

constexpr double water_depth = 0.5, gravity = 9.81;  ///< of still water [m], [m/s^2]

/// Something that could go on for ever without a loss, or at rest.
struct Case {
  const char *name, *energy_of;  ///< what the error of the energy is measured by
  std::function<std::unique_ptr<Simulation>()> start;
  std::function<double(Simulation&)> scale;  ///< of the energy, at the start
  double weight;
};

double kinetic_energy(Simulation& simulation) { return simulation.energy().kinetic; }

double potential_energy(Simulation& simulation) { return simulation.energy().potential; }

std::unique_ptr<Simulation> bouncing_stack(const char* dt) {
  return simulation(
      scene("stage2/stack", {{"drag", "0"}, {"restitution", "1"}, {"particles", "10"}, {"dt", dt}}));
}

const std::array cases{
    // Twelve discs pressed between two that do not move, by steps of a quarter of the longest stable one.
    Case{"springs", "kinetic energy",
         [] {
           const double w = highest_frequency(12, 1.5e5, 1);
           return pressed_row(12, {{"drag", "0"}, {"dt", to_text(0.5 / w)}});
         },
         kinetic_energy, 1},
    // As they are in the scene: discs let go of each other, and of the floor, and meet again. With the step
    // that the scene takes by itself, 1.05 ms, and with half of it.
    Case{"bouncing stack", "potential energy", [] { return bouncing_stack("auto"); }, potential_energy, 1},
    Case{"bouncing stack at half the step", "potential energy", [] { return bouncing_stack("5.27e-4"); },
         potential_energy, 1},
    // A periodic patch of fluid without viscosity, of which every particle is a little out of place.
    Case{"lattice", "energy",
         [] {
           return simulation(scene("stage4/acoustic", {{"alpha", "0"}, {"dt", "0.26"}}));
         },
         [](Simulation& lattice) { return lattice.energy().mechanical(); }, 8},
    Case{"still water", "potential energy",
         [] {
           return simulation(scene("stage4/still_water", {{"tank_width", "1"},
                                                          {"tank_height", "0.75"},
                                                          {"depth", to_text(water_depth)},
                                                          {"gravity", to_text(gravity)},
                                                          {"spacing", "0.05"}}));
         },
         potential_energy, 40}};

/// What the program holds now, of all that it asked for [byte].
double bytes_held() {
  const auto heap = mallinfo2();
  return static_cast<double>(heap.uordblks + heap.hblkhd);
}

/// How many particles are no longer there, or outside what the scene shows.
Index lost(const Simulation& simulation, Index at_first) {
  const auto& r = simulation.particles().position;
  Index there = 0;
  for (Index i = 0; i < r.rows(); ++i) there += simulation.setup().view.contains(clapotis::row(r, i)) ? 1 : 0;
  return at_first - there;
}

/// What the steps since the sample before came to.
struct Sample {
  long step = 0;
  double time = 0;
  double mean = 0, least = std::numeric_limits<double>::infinity(), most = -least;  ///< error of the energy
  double fastest = 0;
  Index lost = 0;
  double bytes = 0;
};

/// Goes on for the time of one row.
Sample next_sample(Simulation& run, long steps, double start, double scale, Index at_first) {
  Sample now;
  for (long look = 0; look < looks; ++look) {
    advance_steps(run, steps / looks);
    const double error = (run.energy().total() - start) / scale;
    now.mean += error / looks;
    now.least = std::min(now.least, error);
    now.most = std::max(now.most, error);
    now.fastest = std::max(now.fastest, max_speed(run.particles()));
  }
  now.step = run.steps();
  now.time = run.time();
  now.lost = lost(run, at_first);
  now.bytes = bytes_held();
  return now;
}

/// A run that diverges has the rows that show how it came to that.
std::vector<Row> measure(const Case& each, long steps) {
  const auto run = each.start();
  const auto at_first = run->particles().size();
  const double scale = each.scale(*run), start = run->energy().total();
  std::vector<Sample> seen;
  seen.reserve(samples);  // or the samples would look like a leak
  try {
    while (seen.size() < samples) seen.push_back(next_sample(*run, steps / samples, start, scale, at_first));
  } catch (const Diverged&) {
    if (seen.empty()) throw;
  }
  std::vector<Row> rows;
  for (const auto& s : seen)
    rows.push_back(studies::row(s.step, s.time, s.mean, s.least, s.most, s.fastest, s.lost, s.bytes,
                                peak_memory_bytes()));
  return rows;
}

std::vector<Point> points(Effort effort) {
  const long steps = effort == Effort::quick ? quick_steps : full_steps;
  std::vector<Point> all;
  for (const auto& each : cases)
    all.push_back({.key = studies::row(each.name),
                   .measure = [=] { return measure(each, steps); },
                   .weight = each.weight});
  return all;
}

/// How much a straight line through a series rises from its first to its last number.
double trend(const std::vector<double>& y) {
  std::vector<double> x(y.size());
  std::iota(x.begin(), x.end(), 0.0);
  return line_through(x, y).slope * (x.back() - x.front());
}

Conclusion conclude(const Table& table) {
  Conclusion conclusion;
  TextTable runs{.name = "runs",
                 .header = {"run", "steps", "energy measured by", "largest error", "trend", "swing",
                            "fastest at the end", "particles lost", "more bytes at the end"},
                 .rows = {}};
  for (const auto& each : cases) {
    std::string name = each.name;  // of a finding: in one word
    std::replace(name.begin(), name.end(), ' ', '_');
    const auto rows = table.where({{"run", each.name}, {"outcome", "done"}});
    if (rows.size() < 10) continue;
    const auto mean = table.numbers(rows, "energy_error"), bytes = table.numbers(rows, "bytes");
    const auto least = table.numbers(rows, "least"), most = table.numbers(rows, "most");
    const auto fastest = table.numbers(rows, "fastest");
    const double low = *std::min_element(least.begin(), least.end());
    const double high = *std::max_element(most.begin(), most.end());
    double swing = 0;  // within the time of one row: what comes and goes
    for (std::size_t k = 0; k < most.size(); ++k) swing = std::max(swing, most[k] - least[k]);
    const double largest = std::max(high, -low), rise = trend(mean);
    // the first tenth may still fill what grows to what a run needs
    const double leak = bytes.back() - bytes[bytes.size() / 10];
    runs.rows.push_back({each.name, table.text(rows.back(), "step"), each.energy_of, rounded(largest, 2),
                         rounded(rise, 2), rounded(swing, 2), rounded(fastest.back(), 2),
                         table.text(rows.back(), "lost"), cell(leak)});
    const auto of = std::string(each.name) + ": ";
    conclusion.findings.push_back(
        {name + "_steps", table.text(rows.back(), "step"), "", of + "steps that it lasted"});
    conclusion.findings.push_back(
        {name + "_largest", rounded(largest, 2), "", of + "largest error of the energy"});
    conclusion.findings.push_back({name + "_trend", rounded(rise, 2), "", of + "its trend over the run"});
    conclusion.findings.push_back(
        {name + "_swing", rounded(swing, 2), "", of + "swing within a 200th of the run"});
    conclusion.findings.push_back({name + "_leak", cell(leak), "byte", of + "more memory at the end"});
  }
  const auto water = table.where({{"run", "still water"}, {"outcome", "done"}});
  if (!water.empty()) {
    const auto fastest = table.numbers(water, "fastest");
    const double wave = std::sqrt(gravity * water_depth);
    conclusion.findings.push_back({"still_water_speed",
                                   rounded(*std::max_element(fastest.begin(), fastest.end()) / wave, 2), "",
                                   "still water: largest speed over sqrt(g H)"});
    conclusion.findings.push_back({"still_water_last_speed", rounded(fastest.back() / wave, 2), "",
                                   "still water: largest speed over sqrt(g H) at the end"});
  }
  conclusion.tables.push_back(runs);
  return conclusion;
}

}  // namespace

/// `energy_error` is the change of the total energy, dissipated energy included, over the scale of the case:
/// its mean since the row before, the least and the most of it; `fastest` is the largest speed.
Study long_run() {
  return {.name = "long_run",
          .question = "What becomes of energy, particles and memory in a million steps?",
          .keys = {{"run", ""}},
          .values = {{"step", "1"},
                     {"time", "s"},
                     {"energy_error", "1"},
                     {"least", "1"},
                     {"most", "1"},
                     {"fastest", "L/s"},
                     {"lost", "1"},
                     {"bytes", "byte"},
                     {"peak_bytes", "byte"}},
          .points = points,
          .conclude = conclude};
}

}  // namespace clapotis::studies
