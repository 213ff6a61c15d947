#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include "common/measures/energy.hpp"
#include "common/simulation/errors.hpp"
#include "report/studies/measured.hpp"
#include "report/studies/studies.hpp"

namespace clapotis::studies {
namespace {

/// A number that tells what an erratum does, of a run and its energy at the start.
using Quantity = double (*)(Simulation&, const Energy&);

double energy_kept(Simulation& run, const Energy& start) {
  return run.energy().mechanical() / start.mechanical();
}
double energy_dissipated(Simulation& run, const Energy& start) {
  return run.energy().dissipated / start.mechanical();
}
double median_density(Simulation& run, const Energy& /*start*/) {
  const auto& all = run.particles().density;
  std::vector<double> density(all.begin(), all.end());  // of spray, single particles, it tells nothing
  const auto middle = density.begin() + std::ssize(density) / 2;
  std::nth_element(density.begin(), middle, density.end());
  return *middle / run.setup().fluid->state.reference_density;
}
double mach_number(Simulation& run, const Energy& /*start*/) {
  return max_speed(run.particles()) / run.sound_speed();
}
double froude_number(Simulation& run, const Energy& /*start*/) {
  return max_speed(run.particles()) / std::sqrt(9.81 * run.parameters().value("depth"));
}
double pressure_error(Simulation& run, const Energy& /*start*/) { return run.error(); }
double height(Simulation& run, const Energy& /*start*/) { return run.particles().position(0, 1); }

/// A run of what is printed, or of what mends it, from the same start.
struct Variant {
  const char *form, *setting;  ///< "printed", "mended" or another that tells something; and in words
  std::string text;            ///< the scene
};

/// One of the handout's errors. Section 3 of its list; numbers as in the README of stage 4.
struct Erratum {
  const char *number, *printed, *effect;  ///< what is printed, and what that does
  const char *name, *unit;                ///< of the quantity
  Quantity quantity;
  double until;  ///< [s]
  std::vector<Variant> variants;
};

/// The handout's column of 12 x 20 particles.
std::string column(std::vector<std::pair<std::string, std::string>> values, bool monaghan = true) {
  if (monaghan) values.emplace_back("viscosity_form", "monaghan");
  return scene("stage4/handout", values);
}
/// The same with a pixel of a millimetre, in metres: rho_0 = 1000 kg/m^3, the same gravity on the screen.
std::string column_in_metres(const char* viscosity) {
  return scene("stage4/handout", {{"radius", "0.01"},
                                  {"mass", "0.314159"},
                                  {"width", "0.8"},
                                  {"height", "0.6"},
                                  {"gravity", "0.5"},
                                  {"restitution", "1"},
                                  {"viscosity_form", viscosity}});
}
std::string still_water(std::vector<std::pair<std::string, std::string>> values) {
  values.emplace_back("spacing", "0.04");
  return scene("stage4/still_water", values);
}
std::string ball(const char* integrator) {
  return scene("stage1/bounce", {{"drag", "0"}, {"restitution", "1"}, {"integrator", integrator}});
}

std::vector<Erratum> errata() {
  return {
      {"1",
       "explicit Euler: r with the old v",
       "energy grows without end: a ball bounces ever higher",
       "mechanical energy",
       "start",
       energy_kept,
       60,
       {{"printed", "explicit Euler", ball("explicit_euler")},
        {"mended", "Verlet", ball("velocity_verlet")}}},
      {"2",
       "rho_0 = m/(pi h^2) at a spacing of 2h",
       "no neighbour counts: 10/7 rho_0 for all, a gas",
       "median density",
       "rho_0",
       median_density,
       3,
       {{"printed", "handout", column({})},
        {"mended", "consistent", scene("stage4/handout", {{"formulation", "consistent"}})}}},
      {"3",
       "pressure with u from i to j",
       "pressure pulls",
       "largest speed",
       "c",
       mach_number,
       0.03,
       {{"printed", "u from i to j", column({{"signs", "printed"}, {"alpha", "0"}})},
        {"mended", "u from j to i", column({{"alpha", "0"}})}}},
      {"4",
       "viscosity where v_ij.u < 0 with u from i to j",
       "brakes pairs that part; it still takes energy",
       "energy dissipated",
       "start",
       energy_dissipated,
       0.03,
       {{"printed", "u from i to j", column({{"signs", "printed"}, {"alpha", "1"}, {"restitution", "1"}})},
        {"mended", "u from j to i", column({{"alpha", "1"}, {"restitution", "1"}})}}},
      {"5",
       "viscosity times rho; no 1/r",
       "not a force: nothing in pixels, far too much in metres",
       "energy dissipated",
       "start",
       energy_dissipated,
       0.5,
       {{"printed", "in metres", column_in_metres("printed")},
        {"other", "in pixels", column({{"restitution", "1"}}, false)},
        {"mended", "Monaghan 1992", column_in_metres("monaghan")}}},
      {"6",
       "tau = h/c",
       "too long for explicit Euler; shorter steps buy time alone",
       "largest speed",
       "c",
       mach_number,
       2,
       {{"printed", "explicit Euler; h/c", column({{"integrator", "explicit_euler"}})},
        {"other", "explicit Euler; 0.4 h/c", column({{"integrator", "explicit_euler"}, {"cfl", "0.4"}})},
        {"another", "explicit Euler; 0.1 h/c", column({{"integrator", "explicit_euler"}, {"cfl", "0.1"}})},
        {"mended", "Verlet; h/c", column({})}}},
      {"7",
       "walls that only reflect",
       "kernels end at the wall: water at rest never rests",
       "largest speed",
       "sqrt(g H)",
       froude_number,
       4,
       {{"printed", "reflecting walls", still_water({{"walls", "reflect"}})},
        {"mended", "walls of particles", still_water({})}}},
      {"8",
       "density as a sum up to the surface",
       "missing neighbours are tension: the surface is pulled in",
       "error of pressure",
       "1",
       pressure_error,
       2,
       {{"printed", "sum", still_water({{"density", "summation"}, {"tension", "yes"}})},
        {"other", "sum; p at least 0", still_water({{"density", "summation"}})},
        {"mended", "continuity", still_water({})}}},
      {"9",
       "m g in the pressure force and as weight",
       "everything falls with twice the acceleration",
       "height",
       "m",
       height,
       0.31,
       {{"printed", "2 g", scene("stage1/drop", {{"drag", "0"}, {"gravity", "19.62"}})},
        {"mended", "g", scene("stage1/drop", {{"drag", "0"}})}}},
  };
}

/// Some 200 rows of the quantity over time. A run that is lost ends with a row that says so, with the step
/// in which it was, and the last value.
std::vector<Row> curve(const Erratum& erratum, const Variant& variant) {
  const auto run = simulation(variant.text);
  const auto start = run->energy();
  const auto every = std::max(1L, std::lround(erratum.until / run->dt() / 200));
  std::vector<Row> rows;
  double value = 0;
  const auto note = [&](Simulation& s) {
    value = erratum.quantity(s, start);
    rows.push_back(row(s.time(), s.steps(), value, "runs"));
  };
  note(*run);
  try {
    advance(*run, erratum.until, [&](Simulation& s) {
      if (s.steps() % every == 0 || s.time() >= erratum.until) note(s);
    });
  } catch (const Diverged& lost) {
    rows.push_back(row(lost.time, lost.step, value, "lost"));
  }
  return rows;
}

std::vector<Point> points(Effort /*effort*/) {
  std::vector<Point> all;
  for (const auto& erratum : errata())
    for (const auto& variant : erratum.variants)
      all.push_back({.key = row(erratum.number, erratum.name, erratum.unit, variant.form, variant.setting),
                     .measure = [=] { return curve(erratum, variant); },
                     .weight = erratum.number[0] >= '7' ? 10.0 : 1.0});
  return all;
}

/// How a run ended: "lost in step 8", or the last value.
std::string end_of(const Table& table, const char* number, const char* form) {
  const auto rows = table.where({{"erratum", number}, {"form", form}});
  if (rows.empty()) return "-";
  const auto& last = rows.back();
  if (table.text(last, "state") == "lost") return "lost in step " + table.text(last, "step");
  return rounded(table.number(last, "value"));
}

Conclusion conclude(const Table& table) {
  Conclusion all{
      .findings = {},
      .tables = {{.name = "errata",
                  .header = {"", "printed", "what it does", "quantity", "printed ends", "mended ends"},
                  .rows = {}}}};
  for (const auto& erratum : errata()) {
    const std::string unit = erratum.unit;
    all.tables.front().rows.push_back({erratum.number, erratum.printed, erratum.effect,
                                       erratum.name + (unit == "1" ? "" : " [" + unit + "]"),
                                       end_of(table, erratum.number, "printed"),
                                       end_of(table, erratum.number, "mended")});
    for (const auto& variant : erratum.variants)
      all.findings.push_back(
          {std::string("end_") + erratum.number + "_" + variant.form,
           end_of(table, erratum.number, variant.form), "",
           std::string("erratum ") + erratum.number + ": " + erratum.name + " with " + variant.setting});
  }
  all.tables.front().rows.push_back({"10", "annexe 2: P V for the energy; signs of d rho flipped twice",
                                     "the flips cancel: no run can show it", "-", "-", "-"});
  return all;
}

}  // namespace

Study handout_errata() {
  return {.name = "handout_errata",
          .question = "What does each error that is printed in the handout do to a run?",
          .keys = {{"erratum", ""}, {"quantity", ""}, {"unit", ""}, {"form", ""}, {"setting", ""}},
          .values = {{"t", "s"}, {"step", "1"}, {"value", "unit"}, {"state", ""}},
          .points = points,
          .conclude = conclude};
}

}  // namespace clapotis::studies
