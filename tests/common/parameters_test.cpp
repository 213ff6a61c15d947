#include <cmath>
#include <string>

#include "common/simulation/errors.hpp"
#include "common/simulation/quantities.hpp"
#include "tests/catch.hpp"
#include "tests/stage1/drop.hpp"

using namespace clapotis;
using namespace clapotis::tests;
using Catch::Matchers::ContainsSubstring;

namespace {

/// The sentence with which a value is refused before anything runs; empty if it is taken.
std::string refusal(const std::string& name, const std::string& value) {
  try {
    Simulation(drop(), typed({{name, value}}));
  } catch (const BadInput& refused) {
    return refused.what();
  }
  return "";
}

/// The same for a change while the scene runs; checks that a refused one changes nothing.
std::string live_refusal(Simulation& simulation, const std::string& name, const std::string& value) {
  const auto* known = simulation.parameters().find(name);
  const auto text = known != nullptr ? known->text() : "";
  const auto origin = known != nullptr ? known->origin : Origin::law;
  const auto overrides = simulation.parameters().overrides().size();
  const double dt = simulation.dt();
  try {
    simulation.set(name, value);
  } catch (const BadInput& refused) {
    if (known != nullptr) {
      CHECK(simulation.parameters().find(name)->text() == text);
      CHECK(simulation.parameters().find(name)->origin == origin);
    }
    CHECK(simulation.parameters().overrides().size() == overrides);
    CHECK(simulation.dt() == dt);
    return refused.what();
  }
  return "";
}

}  // namespace

TEST_CASE("what is not a number is refused with name, value, range and unit", "[parameters]") {
  const std::string value = GENERATE("nan", "NaN", "inf", "-inf", "infinity", "", " 1", "1 ", "1e999", "abc",
                                     "1x", "0x10", "--1", "+-1", "1.2.3", "one", "\t");
  CAPTURE(value);
  CHECK_THAT(refusal("mass", value),
             ContainsSubstring("mass = " + value + " ") && ContainsSubstring("> 0 kg"));
  CHECK_THAT(refusal("gravity", value),
             ContainsSubstring("gravity = " + value + " ") && ContainsSubstring(">= 0 m/s^2"));
  CHECK_THAT(refusal("dt", value), ContainsSubstring("> 0 s, or auto"));
  CHECK_THAT(refusal("x0", value),
             ContainsSubstring("x0 must be any finite number") && ContainsSubstring(" m"));
  Simulation running(drop());
  CHECK_THAT(live_refusal(running, "gravity", value), ContainsSubstring("gravity = " + value + " "));
}

TEST_CASE("a decimal comma is refused with the dot that is meant", "[parameters]") {
  CHECK_THAT(refusal("mass", "1,5"),
             ContainsSubstring("mass = 1,5 ") && ContainsSubstring("decimals are written with a dot"));
}

TEST_CASE("a value out of its range is refused with name, value, range and unit", "[parameters]") {
  CHECK_THAT(refusal("mass", "0"), ContainsSubstring("mass = 0 kg is out of range: mass must be > 0 kg"));
  CHECK_THAT(refusal("mass", "-1"), ContainsSubstring("mass = -1 kg"));
  CHECK_THAT(refusal("radius", "0"), ContainsSubstring("radius = 0 m is out of range: radius must be > 0 m"));
  CHECK_THAT(refusal("gravity", "-9.81"), ContainsSubstring("gravity must be >= 0 m/s^2"));
  CHECK_THAT(refusal("restitution", "1.01"), ContainsSubstring("restitution must be between 0 and 1"));
  CHECK_THAT(refusal("dt", "0"), ContainsSubstring("dt = 0 s is out of range: dt must be > 0 s, or auto"));
  CHECK_THAT(refusal("cfl", "-1"), ContainsSubstring("cfl must be > 0"));
  CHECK_THAT(refusal("drag", "-1e-300"), ContainsSubstring("drag must be >= 0 kg/s"));
  Simulation running(drop());
  CHECK_THAT(live_refusal(running, "restitution", "-0.1"), ContainsSubstring("between 0 and 1"));
  CHECK_THAT(live_refusal(running, "dt", "-1"), ContainsSubstring("> 0 s, or auto"));
}

TEST_CASE("numbers are taken in every usual spelling", "[parameters]") {
  for (const std::string text : {"1.5", "+1.5", "15e-1", "0.15e+1", "1.50", "01.5"}) {
    Simulation simulation(drop(), typed({{"mass", text}}));
    CHECK(simulation.parameters().value("mass") == 1.5);
  }
}

TEST_CASE("an integer with decimals is refused, and a choice that is none", "[parameters]") {
  Parameters p("m", {}, typed({{"count", 2.5}, {"side", "lft"}}));
  const Parameter count{.name = "count", .symbol = "N", .unit = "", .value = 1, .range = positive};
  CHECK_THROWS_WITH(p.integer(count), ContainsSubstring("count = 2.5") && ContainsSubstring("whole number") &&
                                          ContainsSubstring("> 0"));
  const Parameter side{.name = "side", .symbol = "", .unit = "", .choices = {"left", "right"}};
  CHECK_THROWS_WITH(p.choice(side), ContainsSubstring("side = lft") && ContainsSubstring("left, right") &&
                                        ContainsSubstring("did you mean left?"));
  CHECK_THAT(refusal("impacts", "locate"), ContainsSubstring("did you mean located?"));
  CHECK_THAT(refusal("impacts", "0"), ContainsSubstring("located, clamp"));
}

TEST_CASE("a list takes numbers with commas between, or none, and says which of them it cannot use",
          "[parameters]") {
  const auto read = [](const std::string& text) {
    Parameters p("m", {}, typed({{"probes", text}}));
    return p.numbers({.name = "probes", .symbol = "", .unit = "L", .range = {.low = 0, .high = 2}});
  };
  using Numbers = std::vector<double>;
  CHECK(read("0.1,0.5") == Numbers{0.1, 0.5});
  CHECK(read("2,0,+1e-3") == Numbers{2, 0, 1e-3});  // in the order given
  CHECK(read("1") == Numbers{1});
  CHECK(read("none").empty());
  CHECK_THROWS_WITH(read("0.1,3"),
                    ContainsSubstring("probes = 3 m is out of range") &&
                        ContainsSubstring("between 0 and 2 m each, with commas between, or none"));
  CHECK_THROWS_WITH(read("0.1;0.5"), ContainsSubstring("probes = 0.1;0.5 is not a finite number"));
  CHECK_THROWS_WITH(read("0.5,0.1,0.50"), ContainsSubstring("names 0.5 twice"));
  for (const std::string nothing : {"", ",", "0.1,", ",0.1", "0.1,,0.5", "0.1, 0.5", "nan", "none,1"})
    CHECK_THROWS_WITH(read(nothing), ContainsSubstring("is not a finite number"));

  Parameters p("m", {{"probes", "0.25,1"}}, {});
  const Parameter probes{.name = "probes", .symbol = "", .unit = "L", .range = {.low = 0, .high = 2}};
  CHECK(p.numbers(probes) == Numbers{0.25, 1});  // of the scene
  CHECK(p.find("probes")->text() == "0.25,1");
  p.set("probes", "none", Origin::window);
  CHECK(p.find("probes")->text() == "none");
  CHECK_THROWS(p.set("probes", "1,5", Origin::window));
  CHECK(p.find("probes")->values.empty());  // as it was
}

TEST_CASE("an unknown name is refused with the nearest known one and the list of all", "[parameters]") {
  CHECK_THAT(refusal("gravty", "1"), ContainsSubstring("no parameter gravty") &&
                                         ContainsSubstring("did you mean gravity?") &&
                                         ContainsSubstring("restitution"));
  CHECK_THAT(refusal("Mass", "1"), ContainsSubstring("did you mean mass?"));
  Simulation running(drop());
  CHECK_THAT(live_refusal(running, "restitutoin", "0.5"), ContainsSubstring("did you mean restitution?"));
  CHECK_THROWS_WITH(stage1::stage().scene("dropp"), ContainsSubstring("did you mean drop?"));
  CHECK_THROWS_WITH(Simulation(drop(), {}, "rk3"), ContainsSubstring("did you mean rk2?"));
}

TEST_CASE("what only a new start can change is refused while the scene runs", "[parameters]") {
  Simulation running(drop());
  for (const auto& p : running.parameters().all()) {
    CAPTURE(p.name);
    if (p.change == Change::live) {
      CHECK(live_refusal(running, p.name, p.text()).empty());
    } else {
      CHECK_THAT(live_refusal(running, p.name, p.text()),
                 ContainsSubstring(p.name) && ContainsSubstring("starts anew"));
    }
  }
  const auto changes = [&](const char* name) { return running.parameters().find(name)->change; };
  CHECK(changes("gravity") == Change::live);
  CHECK(changes("drag") == Change::live);
  CHECK(changes("restitution") == Change::live);
  CHECK(changes("dt") == Change::live);
  CHECK(changes("mass") == Change::restart);
  CHECK(changes("y0") == Change::restart);
  CHECK(changes("impacts") == Change::restart);
}

TEST_CASE("the law's value gives way to the scene's, that to the user's, and that to the window's",
          "[parameters]") {
  Simulation simulation(drop(), {{"drag", {"2", Origin::file}}});
  const auto of = [&](const char* name) { return *simulation.parameters().find(name); };
  CHECK((of("restitution").value == 0.8 && of("restitution").origin == Origin::law));
  CHECK((of("radius").value == 0.05 && of("radius").origin == Origin::scene));
  CHECK((of("drag").value == 2 && of("drag").origin == Origin::file));
  simulation.set("drag", "3");
  CHECK((of("drag").value == 3 && of("drag").origin == Origin::window));
  // A reset starts from what was asked for last.
  Simulation again(drop(), simulation.parameters().overrides());
  CHECK(again.parameters().value("drag") == 3);
  CHECK(name_of(Origin::environment) == "environment");
}

TEST_CASE("L in a unit is the scene's unit of length", "[parameters]") {
  Simulation metres(drop()), pixels(bounce());
  CHECK(metres.parameters().find("gravity")->unit == "m/s^2");
  CHECK(pixels.parameters().find("gravity")->unit == "px/s^2");
  CHECK(pixels.parameters().find("radius")->unit == "px");
  CHECK(pixels.parameters().find("vx0")->unit == "px/s");
  CHECK(pixels.parameters().find("mass")->unit == "kg");
}

TEST_CASE("a live change takes effect from the next step on", "[parameters]") {
  Simulation simulation(drop(), typed({{"drag", 0.0}, {"dt", 0.01}}));
  run_steps(simulation, 10);
  simulation.set("gravity", "0");
  const auto v = velocity(simulation);
  run_steps(simulation, 5);
  CHECK(velocity(simulation) == v);
  simulation.set("gravity", "9.81");
  simulation.step();
  CHECK(velocity(simulation).y == Approx(v.y - g * 0.01).epsilon(1e-14));
}

TEST_CASE("a scene in which nothing moves and nothing falls asks for a time step", "[parameters]") {
  const Values still{{"gravity", 0.0}, {"drag", 0.0}};
  CHECK_THROWS_WITH(Simulation(drop(), typed(still)), ContainsSubstring("give dt a number of seconds"));
  auto with_dt = still;
  with_dt.emplace_back("dt", 0.1);
  Simulation simulation(drop(), typed(with_dt));
  run_steps(simulation, 10);
  CHECK(position(simulation) == Vector{0.75, 1});
}

TEST_CASE("an automatic time step is the share of h/c that cfl says", "[parameters]") {
  const double c = 10 * std::sqrt(2 * g * 1.2);
  CHECK(Simulation(drop()).dt() == Approx(0.05 / c).epsilon(1e-14));
  CHECK(Simulation(drop(), typed({{"cfl", 0.5}})).dt() == Approx(0.025 / c).epsilon(1e-14));
  CHECK(Simulation(drop(), typed({{"cfl", 0.5}, {"dt", 0.007}})).dt() == 0.007);
  Simulation thick(drop(), typed({{"drag", 1e4}}));
  CHECK(thick.binding_limit().name == "drag");
  CHECK(thick.dt() == Approx(0.25 * 2 / 1e4).epsilon(1e-14));
  thick.set("dt", "1e-6");
  CHECK(thick.dt() == 1e-6);
  thick.set("dt", "auto");
  CHECK(thick.dt() == Approx(0.25 * 2 / 1e4).epsilon(1e-14));
}
