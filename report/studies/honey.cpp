#include <algorithm>
#include <array>
#include <cmath>

#include "common/references/channel_start.hpp"
#include "report/studies/flows.hpp"
#include "report/studies/studies.hpp"

namespace clapotis::studies {
namespace {

constexpr std::array flows{"couette", "poiseuille"}, steps{"explicit", "implicit"};
/// When Morris, Fox & Zhu 1997 look at the profile, and when it is as good as steady [d^2/nu].
constexpr std::array morris{0.0225, 0.045, 0.1125, 0.225};
constexpr double steady = 1;
const double nothing = std::nan("");

/// A channel of the depth d with a liquid that is brought to the speed U.
struct Channel {
  std::string flow, step;
  int resolution;  ///< d/dx
  double depth, nu, speed;
  double dt = std::nan("");  ///< of automatic length unless it is given

  /// d^2/nu [s], what momentum takes to cross it.
  [[nodiscard]] double crossing() const { return depth * depth / nu; }
  [[nodiscard]] double force() const { return flow == "poiseuille" ? 8 * nu * speed / (depth * depth) : 0; }
  [[nodiscard]] double plate_speed() const { return flow == "couette" ? speed : 0; }
  [[nodiscard]] std::string text() const {
    return scene("stage5/" + flow, {{"depth", to_text(depth)},
                                    {"length", to_text(0.4 * depth)},
                                    {"spacing", to_text(depth / resolution)},
                                    {"nu", to_text(nu)},
                                    {"driving", to_text(force())},
                                    {"plate_speed", to_text(plate_speed())},
                                    {"viscous_step", step},
                                    {"dt", std::isnan(dt) ? "auto" : to_text(dt)}});
  }
};

/// The mean speed of each layer of particles, against the series.
void add_profile(std::vector<Row>& rows, const Channel& channel, const Simulation& run, double instant) {
  const ChannelStart exact{.depth = channel.depth,
                           .viscosity = channel.nu,
                           .force = channel.force(),
                           .plate_speed = channel.plate_speed()};
  const auto layers = static_cast<std::size_t>(channel.resolution);
  std::vector<double> sums(layers), counts(layers);
  for (Index i = 0; i < run.particles().size(); ++i) {
    const double layer = run.particles().position(i, 1) / channel.depth * channel.resolution;
    const auto k = static_cast<std::size_t>(std::clamp(layer, 0.0, channel.resolution - 1.0));
    sums[k] += run.particles().velocity(i, 0), ++counts[k];
  }
  for (std::size_t k = 0; k < layers; ++k) {
    const double y = (static_cast<double>(k) + 0.5) / channel.resolution;
    rows.push_back(row("curve", instant, y, sums[k] / counts[k] / channel.speed,
                       exact.velocity(y * channel.depth, run.time()) / channel.speed));
  }
}

/// The largest error of any particle at Morris' instants, and of the steady flow if that is `awaited`.
std::vector<Row> start_up(const Channel& channel, bool awaited, bool drawn) {
  const auto run = simulation(channel.text());
  const double step = run->dt(), h = run->smoothing_length();
  std::vector<Row> curve;
  double error = 0;
  for (const double instant : morris) {
    advance(*run, instant * channel.crossing());
    error = std::max(error, run->error());
    if (drawn) add_profile(curve, channel, *run, instant);
  }
  const auto cost = cost_until(channel.text(), morris.back() * channel.crossing(), 3);
  const double simulated = morris.back() * channel.crossing();
  double late = nothing;
  if (awaited) {
    advance(*run, steady * channel.crossing());
    late = run->error();
  }
  std::vector<Row> rows{row("run", nothing, nothing, nothing, nothing, step, channel.nu * step / (h * h),
                            error, late, cost.steps, cost.seconds.median / simulated, cost.seconds.spread)};
  rows.insert(rows.end(), curve.begin(), curve.end());
  return rows;
}

/// Water in a gap of a millimetre, as Morris has it.
Channel gap(const char* flow, int resolution) { return {flow, "explicit", resolution, 1e-3, 1e-6, 1.25e-5}; }
/// Something as viscous as honey, a centimetre deep.
Channel thick(const char* flow, const char* step, int resolution) {
  return {flow, step, resolution, 0.01, 7e-3, 0.15};
}

std::vector<Point> points(Effort effort) {
  const bool quick = effort == Effort::quick;
  std::vector<Point> all;
  const auto add = [&](const char* sweep, const Channel& channel, const std::string& dt, double weight) {
    const bool awaited = std::string_view(sweep) == "step", drawn = channel.resolution == 20;
    all.push_back({.key = row(sweep, channel.flow, channel.step, channel.resolution, channel.nu, dt),
                   .measure = [=] { return start_up(channel, awaited, drawn); },
                   .weight = weight});
  };
  for (const int resolution : {10, 20, 30, 40, 60, 80}) {
    if (quick && (resolution > 40 || resolution == 30)) continue;
    for (const char* flow : flows)
      add("spacing", gap(flow, resolution), "auto", std::pow(resolution / 20.0, 4));
  }
  const int resolution = quick ? 25 : 50;
  const double unit = quick ? 1 : 12;
  for (const char* flow : flows) {
    for (const char* step : steps) {
      const bool implicit = std::string_view(step) == "implicit";
      for (double part = implicit ? 0.125 : 0.0625; part <= (implicit ? 16 : 0.5); part *= 2) {
        auto channel = thick(flow, step, resolution);
        const double h = 1.5 * channel.depth / resolution;  // the scene's h/dx
        channel.dt = part * h * h / channel.nu;
        add("step", channel, to_text(channel.dt), unit * std::min(2.0, 0.125 / part));
      }
    }
  }
  for (const char* step : steps)
    for (const double nu : {7e-5, 3.5e-4, 7e-4, 3.5e-3, 7e-3, 7e-2}) {
      auto channel = thick("couette", step, resolution);
      channel.nu = nu;
      add("viscosity", channel, "auto", unit / 2);
    }
  return all;
}

/// The lowest cost of those runs that are no more wrong than `most`.
double cheapest(const Table& table, const std::vector<Row>& runs, std::string_view column, double most) {
  double least = nothing;
  for (const auto& run : runs) {
    const double seconds = table.number(run, "seconds");
    if (table.number(run, column) <= most && !(least <= seconds)) least = seconds;
  }
  return least;
}

/// Where implicit friction begins to be cheaper, between the viscosities that were tried [m^2/s].
double crossover(const Table& table) {
  const auto slow = table.where({{"sweep", "viscosity"}, {"step", "explicit"}, {"part", "run"}}),
             fast = table.where({{"sweep", "viscosity"}, {"step", "implicit"}, {"part", "run"}});
  double last = nothing, last_nu = nothing;
  for (std::size_t k = 0; k < std::min(slow.size(), fast.size()); ++k) {
    if (table.text(slow[k], "nu") != table.text(fast[k], "nu")) return nothing;  // one of them diverged
    const double gain = std::log(table.number(slow[k], "seconds") / table.number(fast[k], "seconds")),
                 nu = table.number(slow[k], "nu");
    if (last < 0 && gain >= 0) return last_nu * std::pow(nu / last_nu, last / (last - gain));
    last = gain, last_nu = nu;
  }
  return nothing;
}

Conclusion conclude(const Table& table) {
  std::vector<Finding> findings;
  TextTable fastest{
      .name = "speed_up", .header = {"flow", "wanted error", "explicit", "implicit", "speed-up"}, .rows = {}};
  for (const std::string flow : flows) {
    const auto spacings = table.where({{"sweep", "spacing"}, {"flow", flow}, {"part", "run"}});
    if (spacings.empty()) continue;
    const auto order = power_law(table.numbers(spacings, "d_over_dx"), table.numbers(spacings, "error"));
    findings.push_back(
        {flow + "_order", rounded(-order.exponent, 2), "", flow + ": order in dx of the error"});
    findings.push_back({flow + "_error", rounded(100 * table.number(spacings.back(), "error"), 2), "%",
                        flow + ": error with d/dx = " + table.text(spacings.back(), "d_over_dx")});
    const auto runs = [&](std::string_view step) {
      return table.where({{"sweep", "step"}, {"flow", flow}, {"step", step}, {"part", "run"}});
    };
    const auto compare = [&](std::string_view column, double most, const std::string& name) {
      const double slow = cheapest(table, runs("explicit"), column, most),
                   fast = cheapest(table, runs("implicit"), column, most);
      fastest.rows.push_back({flow, name, rounded(slow), rounded(fast), rounded(slow / fast, 2)});
      return slow / fast;
    };
    compare("error", 0.005, "0.5 % while it grows");
    compare("error", 0.02, "2 % while it grows");
    double at_limit = nothing;
    for (const auto& run : runs("explicit")) at_limit = table.number(run, "steady_error");
    const double gain = compare("steady_error", 1.05 * at_limit, "of the steady flow");
    findings.push_back({flow + "_speed_up", rounded(gain, 2), "",
                        flow + ": implicit over explicit for a steady flow that is as good"});
  }
  double borne = 0;
  for (const auto& run : table.where({{"sweep", "step"}, {"step", "explicit"}, {"part", "run"}}))
    borne = std::max(borne, table.number(run, "viscous_number"));
  findings.push_back({"borne", rounded(borne, 2), "",
                      "longest step that explicit friction bore, nu dt/h^2 (twice as long ones diverge)"});
  findings.push_back({"crossover", rounded(crossover(table), 2), "m^2/s",
                      "viscosity from which implicit friction is cheaper"});
  return {.findings = findings, .tables = {fastest}};
}

}  // namespace

Study honey() {
  return {
      .name = "honey",
      .question =
          "How near does a viscous liquid come to the profiles of a channel, and when do implicit steps pay?",
      .keys = {{"sweep", ""},
               {"flow", ""},
               {"step", ""},
               {"d_over_dx", "1"},
               {"nu", "m^2/s"},
               {"wanted_dt", "s"}},
      .values = {{"part", ""},
                 {"instant", "d^2/nu"},
                 {"y", "d"},
                 {"speed", "U"},
                 {"exact_speed", "U"},
                 {"dt", "s"},
                 {"viscous_number", "1"},
                 {"error", "1"},
                 {"steady_error", "1"},
                 {"steps", "1"},
                 {"seconds", "s/s"},
                 {"spread", "1"}},
      .points = points,
      .conclude = conclude};
}

}  // namespace clapotis::studies
