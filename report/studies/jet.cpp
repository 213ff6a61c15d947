#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "common/laws/dummy_walls.hpp"
#include "common/references/draining_tank.hpp"
#include "common/references/impinging_jet.hpp"
#include "common/runner/stopwatch.hpp"
#include "report/studies/flows.hpp"
#include "report/studies/studies.hpp"

namespace clapotis::studies {
namespace {

constexpr std::array drawn{5, 20};  // d/dx of the profiles that are drawn
const double nothing = std::nan("");

/// Pressure along the plate, both halves alike, mean over time: of the particles of the plate's first layer.
class PlateProfile {
 public:
  PlateProfile(const Simulation& run, double spacing) {
    const auto& places = run.model().wall_particles()->places;
    for (Index k = 0; k < places.rows(); ++k)
      if (places(k, 1) > -spacing && places(k, 0) > 0) right_.push_back(k);
    std::sort(right_.begin(), right_.end(), [&](Index a, Index b) { return places(a, 0) < places(b, 0); });
    for (const Index k : right_) left_.push_back(opposite(places, k, spacing));
    sums_.resize(right_.size());
  }
  void add(const Simulation& run) {
    const auto& pressure = run.model().wall_particles()->columns.pressure;
    for (std::size_t k = 0; k < sums_.size(); ++k) sums_[k] += (pressure(left_[k]) + pressure(right_[k])) / 2;
    ++count_;
  }
  [[nodiscard]] std::size_t size() const { return sums_.size(); }
  [[nodiscard]] double place(const Simulation& run, std::size_t k) const {
    return run.model().wall_particles()->places(right_[k], 0);
  }
  [[nodiscard]] double mean(std::size_t k) const { return sums_[k] / count_; }

 private:
  static Index opposite(const Vectors& places, Index k, double spacing) {
    for (Index i = 0; i < places.rows(); ++i)
      if (std::abs(places(i, 0) + places(k, 0)) < spacing / 4 &&
          std::abs(places(i, 1) - places(k, 1)) < spacing / 4)
        return i;
    return k;
  }
  std::vector<Index> left_, right_;
  std::vector<double> sums_;
  double count_ = 0;
};

/// The jet as it has become steady: force and pressure from t = 8 d/U to 20 d/U.
std::vector<Row> impinging(int resolution) {
  const ImpingingJet exact{.width = 0.1, .speed = 1, .density = 1000};  // the scene's
  const double dx = exact.width / resolution, crossing = exact.width / exact.speed;
  const auto jet = simulation(scene("stage5/jet", {{"spacing", to_text(dx)}}));
  advance(*jet, 8 * crossing);
  PlateProfile profile(*jet, dx);
  double sum = 0, squares = 0, count = 0;
  advance(*jet, 20 * crossing, [&](Simulation& run) {
    const double force = measure(run, "plate_force") / exact.force();
    sum += force, squares += force * force, ++count;
    profile.add(run);
  });
  const double force = sum / count, shake = std::sqrt(squares / count - force * force);
  std::vector<Row> curve;
  double errors = 0, near = 0;
  for (std::size_t k = 0; k < profile.size(); ++k) {
    const double x = profile.place(*jet, k), whole = exact.pressure(0);
    if (x > 2.5 * exact.width) break;  // the plate ends at 3 d
    const double measured = profile.mean(k) / whole, wanted = exact.pressure(x) / whole;
    errors += (measured - wanted) * (measured - wanted), ++near;
    curve.push_back(row("curve", x / exact.width, measured, wanted));
  }
  const auto cost = cost_per_second(*jet);
  std::vector<Row> rows{row("run", nothing, nothing, nothing, jet->particles().size(), force,
                            std::abs(force - 1), shake, profile.mean(0) / exact.pressure(0),
                            std::sqrt(errors / near), nothing, cost.median, cost.spread)};
  if (std::find(drawn.begin(), drawn.end(), resolution) != drawn.end())
    rows.insert(rows.end(), curve.begin(), curve.end());
  return rows;
}

/// A tank that empties: by how much its jet contracts, from how fast the root of the level falls. Its cost is
/// that of the whole run, with what looks at it.
std::vector<Row> emptying(int resolution) {
  const DrainingTank exact{.width = 1, .slot = 0.1, .depth = 0.6, .gravity = 9.81};  // the scene's
  const auto tank = simulation(scene("stage5/draining", {{"spacing", to_text(exact.slot / resolution)}}));
  std::vector<Row> curve;
  Series roots;
  double most = 0, next = 0;
  const auto look = [&](Simulation& run) {
    const double root = std::sqrt(measure(run, "level"));
    if (run.time() > 0.2) roots.add(run.time(), root);  // the jet has formed
    most = std::max(most, run.error());
    if (run.time() < next) return;
    next += 0.05;
    curve.push_back(row("curve", run.time(), root / std::sqrt(exact.depth),
                        std::sqrt(exact.level(run.time()) / exact.depth)));
  };
  const auto particles = tank->particles().size();
  constexpr double until = 1.6;  // half of the water is gone: each second costs less than the one before
  const double start = processor_seconds();
  advance(*tank, until, look);
  const double seconds = (processor_seconds() - start) / until;
  const double contraction =
      -line_through(roots.t, roots.y).slope / (exact.slot / exact.width * std::sqrt(exact.gravity / 2));
  std::vector<Row> rows{row("run", nothing, nothing, nothing, particles, nothing, most, nothing, nothing,
                            nothing, contraction, seconds)};
  if (resolution == 10) rows.insert(rows.end(), curve.begin(), curve.end());
  return rows;
}

std::vector<Point> points(Effort effort) {
  const bool quick = effort == Effort::quick;
  std::vector<Point> all;
  for (const int resolution : {5, 10, 20, 40})
    if (!quick || resolution <= 20)
      all.push_back({.key = row("jet", resolution),
                     .measure = [=] { return impinging(resolution); },
                     .weight = std::pow(resolution / 5.0, 3)});
  for (const int resolution : {5, 10, 20})
    if (!quick || resolution <= 10)
      all.push_back({.key = row("draining", resolution),
                     .measure = [=] { return emptying(resolution); },
                     .weight = 5 * std::pow(resolution / 5.0, 3)});
  return all;
}

Conclusion conclude(const Table& table) {
  TextTable result{
      .name = "jet",
      .header = {"d/dx", "force", "its shaking [%]", "Cp in the middle", "rms error of Cp", "CPU s per s"},
      .rows = {}};
  const auto runs = table.where({{"flow", "jet"}, {"part", "run"}}),
             drained = table.where({{"flow", "draining"}, {"part", "run"}});
  for (const auto& run : runs)
    result.rows.push_back(
        {table.text(run, "resolution"), rounded(table.number(run, "force")),
         rounded(100 * table.number(run, "shaking"), 2), rounded(table.number(run, "middle")),
         rounded(table.number(run, "profile_error"), 2), rounded(table.number(run, "seconds"), 2)});
  TextTable tank{.name = "draining", .header = {"b/dx", "C_c", "CPU s per s"}, .rows = {}};
  for (const auto& run : drained)
    tank.rows.push_back({table.text(run, "resolution"), rounded(table.number(run, "contraction")),
                         rounded(table.number(run, "seconds"), 2)});
  auto resolved = runs;  // with 5 particles across there is no profile
  std::erase_if(resolved, [&](const Row& run) { return table.number(run, "resolution") < 10; });
  const auto order =
      power_law(table.numbers(resolved, "resolution"), table.numbers(resolved, "profile_error"));
  std::vector<Finding> findings{
      {"profile_order", rounded(-order.exponent, 2), "",
       "order in dx of the pressure along the plate, from d/dx = 10 on"},
      {"kirchhoff", rounded(std::numbers::pi / (std::numbers::pi + 2)), "", "C_c of Kirchhoff"}};
  if (!runs.empty()) {
    findings.push_back({"force", rounded(table.number(runs.back(), "force")), "",
                        "force over rho U^2 d with d/dx = " + table.text(runs.back(), "resolution")});
    findings.push_back(
        {"shaking", rounded(100 * table.number(runs.back(), "shaking"), 2), "%", "by which it shakes (rms)"});
  }
  if (!drained.empty())
    findings.push_back({"contraction", rounded(table.number(drained.back(), "contraction")), "",
                        "C_c with b/dx = " + table.text(drained.back(), "resolution")});
  return {.findings = findings, .tables = {result, tank}};
}

}  // namespace

Study jet() {
  return {
      .name = "jet",
      .question =
          "How hard does a jet press on a plate, and how fast does a tank drain, against free streamlines?",
      .keys = {{"flow", ""}, {"resolution", "1"}},
      .values = {{"part", ""},
                 {"x", "d or s"},
                 {"y", "1"},
                 {"exact", "1"},
                 {"particles", "1"},
                 {"force", "1"},
                 {"error", "1"},
                 {"shaking", "1"},
                 {"middle", "1"},
                 {"profile_error", "1"},
                 {"contraction", "1"},
                 {"seconds", "s/s"},
                 {"spread", "1"}},
      .points = points,
      .conclude = conclude};
}

}  // namespace clapotis::studies
