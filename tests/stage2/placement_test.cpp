#include <cmath>

#include "common/simulation/errors.hpp"
#include "stage2_cloud/scenes.hpp"
#include "tests/catch.hpp"
#include "tests/common/discs.hpp"

using namespace clapotis;
using namespace clapotis::tests;

namespace {

constexpr Rectangle room{10, 790, 200, 590};

double least_distance(const Vectors& r) {
  double least = std::numeric_limits<double>::infinity();
  for (Index i = 0; i < r.rows(); ++i)
    for (Index j = 0; j < i; ++j) least = std::min(least, norm(row(r, i) - row(r, j)));
  return least;
}

}  // namespace

TEST_CASE("a cloud is placed within its room and without a contact, however many discs there are",
          "[stage2]") {
  for (const Index n : {1, 2, 7, 100, 500, 869}) {
    const Vectors r = scattered_discs(n, 10, {10, 790, 210, 590}, 1, "px");
    CAPTURE(n);
    REQUIRE(r.rows() == n);
    CHECK(r.col(0).minCoeff() >= 10);
    CHECK(r.col(0).maxCoeff() <= 790);
    CHECK(r.col(1).minCoeff() >= 210);
    CHECK(r.col(1).maxCoeff() <= 590);
    CHECK(least_distance(r) >= 20 * (1 - 1e-9));  // the lattice may be stretched by that to fit
  }
}

TEST_CASE("the same seed places the same cloud, another seed another one", "[stage2]") {
  const Vectors once = scattered_discs(300, 10, room, 42, "px");
  CHECK((scattered_discs(300, 10, room, 42, "px") == once).all());
  CHECK_FALSE((scattered_discs(300, 10, room, 43, "px") == once).all());

  const Scene scene = stage2::stage().scene("cloud");
  Simulation first(scene, typed({{"seed", 7.0}})), second(scene, typed({{"seed", 7.0}})),
      other(scene, typed({{"seed", 8.0}}));
  for (auto* sim : {&first, &second, &other}) run_steps(*sim, 300);
  CHECK((first.particles().position == second.particles().position).all());
  CHECK((first.particles().velocity == second.particles().velocity).all());
  CHECK_FALSE((first.particles().position == other.particles().position).all());
}

TEST_CASE("a cloud starts without any energy in its springs", "[stage2]") {
  for (const double n : {1.0, 500.0, 869.0}) {
    Simulation sim(stage2::stage().scene("cloud"), typed({{"particles", n}}));
    CHECK(sim.energy().elastic < 1e-9);
    CHECK(sim.energy().kinetic == 0);
  }
}

TEST_CASE("discs that do not fit are refused with the number that does, before any memory is taken",
          "[stage2]") {
  const Scene scene = stage2::stage().scene("cloud");
  CHECK_NOTHROW(Simulation(scene, typed({{"particles", 869.0}})));
  CHECK_THROWS_WITH(Simulation(scene, typed({{"particles", 870.0}})),
                    "particles = 870 discs of radius 10 px do not fit: at most 869 do");
  CHECK_THROWS_WITH(Simulation(scene, typed({{"particles", 1e8}})),  // their columns would be 5 GB
                    "particles = 100000000 discs of radius 10 px do not fit: at most 869 do");
  CHECK_THROWS_AS(Simulation(scene, typed({{"radius", 301.0}})), BadInput);
  CHECK_THROWS_WITH(Simulation(scene, typed({{"x0", 795.0}})),
                    "x0 = 795 px is outside the walls: x0 must be between 0 and 780 px");
  CHECK_THROWS_WITH(Simulation(scene, typed({{"y0", -1.0}})),
                    "y0 = -1 px is outside the walls: y0 must be between 0 and 580 px");
}

TEST_CASE("discs of any smallness are placed", "[stage2]") {
  const double radius = GENERATE(1e-3, 1e-6, 1e-9, 1e-100, 1e-300);
  const Vectors r = scattered_discs(50, radius, room, 1, "px");
  CAPTURE(radius);
  CHECK(r.allFinite());
  CHECK(least_distance(r) >= 2 * radius);
  CHECK(r.col(0).maxCoeff() <= room.right);
  CHECK(r.col(1).maxCoeff() <= room.top);
}

TEST_CASE("discs in a box hardly wider than they are stay in one column, in their order", "[stage2]") {
  Simulation sim(stage2::stage().scene("cloud"),
                 typed({{"width", 21.0}, {"particles", 11.0}, {"drag", 5.0}}));
  run_steps(sim, 5000);
  const auto& r = sim.particles().position;
  CHECK((r.col(0) >= 10 && r.col(0) <= 11).all());
  CHECK((r.col(1).tail(10) - r.col(1).head(10) > 19).all());
  CHECK(sim.warnings().empty());
}
