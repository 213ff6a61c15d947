#include <Eigen/Cholesky>

#include "common/kernels/wendland_c2.hpp"
#include "common/laws/laminar_viscosity.hpp"
#include "common/laws/newtonian_viscosity.hpp"
#include "common/simulation/implicit_step.hpp"
#include "stage5_extensions/parameters.hpp"
#include "stage5_extensions/scenes.hpp"
#include "tests/catch.hpp"
#include "tests/common/discs.hpp"
#include "tests/common/momenta.hpp"
#include "tests/stage4/state.hpp"

using namespace clapotis;
using namespace clapotis::tests;

namespace {

/// A block of 8 x 8 particles, a fifth of a spacing out of order, that move at random; on a floor if wanted.
/// A viscous step of it is dt nu/h^2 = 20 long, 160 times what explicit friction bears.
template <class Friction>
struct Block {
  Parameters p{"m", {{"nu", "0.05"}, {"slip", "no"}, {"disturbance", "0.2"}, {"spacing", "0.05"}}, {}};
  Fluid fluid = stage4::liquid(p, 1, stage5::wendland_continuity);
  WendlandC2 kernel{fluid.h};
  Particles particles = stage4::particles_at(stage4::block(fluid.spacing, 0, 0.4, 0, 0.4), p);
  DummyWalls walls;
  FluidArrangement sorted{kernel.support(), {}};
  Implicit<Friction> law = Implicit<Friction>::from(p);
  double dt = 20 * fluid.h * fluid.h / law.friction.nu;

  explicit Block(bool on_floor) {
    if (on_floor)
      walls = DummyWalls(stage4::block(fluid.spacing, -0.2, 0.6, -0.2, 0), fluid, kernel.support());
    stage4::disturb(particles.position, p, fluid.spacing);
    particles.velocity = some_velocities(1);
    particles.density *= 1 + 0.02 * some_velocities(2).col(0);
    sorted.build(particles, [&](Index slot, Index i) {
      sorted.columns.density(slot) = particles.density(i);
      sorted.columns.volume(slot) = fluid.mass / particles.density(i);
    });
  }
  [[nodiscard]] Vectors some_velocities(std::uint64_t seed) const {
    return random_points(particles.size(), {-1, 1, -1, 1}, seed);
  }
  FrictionSweep<WendlandC2, Friction> sweep() { return {law, kernel, sorted, walls, dt / fluid.mass, 1}; }
  /// dt/m F(v)
  Vectors change(const Vectors& v) {
    Vectors result(v.rows(), 2);
    sweep().apply(v, false, result);
    return result;
  }
};

double product(const Vectors& a, const Vectors& b) { return (a * b).sum(); }

}  // namespace

TEMPLATE_TEST_CASE("friction, that of walls included, is symmetric and takes energy out of any motion",
                   "[stage5]", LaminarViscosity, NewtonianViscosity) {
  const bool on_floor = GENERATE(false, true);
  Block<TestType> block(on_floor);
  for (const std::uint64_t seed : {3U, 4U, 5U}) {
    const Vectors u = block.some_velocities(seed), v = block.some_velocities(seed + 10);
    const Vectors of_u = block.change(u), of_v = block.change(v);
    CAPTURE(on_floor, seed);
    // rounding of sums of some thousand terms
    CHECK(std::abs(product(u, of_v) - product(of_u, v)) <
          1e-12 * std::sqrt(product(u, u) * product(of_v, of_v)));
    CHECK(product(v, of_v) < 0);
  }
  Vectors all(block.particles.size(), 2);
  all << Column::Ones(all.rows()), Column::Zero(all.rows());
  // What moves as a whole feels no friction but that of a floor.
  CHECK((product(all, block.change(all)) < -1e-3) == on_floor);
}

TEMPLATE_TEST_CASE("the implicit step solves v - dt/m F(v) = v* as well as its tolerance says", "[stage5]",
                   LaminarViscosity, NewtonianViscosity) {
  Block<TestType> block(true);
  const Index n = block.particles.size();
  Eigen::MatrixXd matrix = Eigen::MatrixXd::Identity(2 * n, 2 * n);
  for (Index k = 0; k < 2 * n; ++k) {
    Vectors one = Vectors::Zero(n, 2);
    one.data()[k] = 1;
    matrix.col(k) -= block.change(one).reshaped().matrix();
  }
  const Vectors before = block.particles.velocity;
  const Eigen::VectorXd exact = matrix.llt().solve(before.reshaped().matrix());
  for (const double tolerance : {1e-2, 1e-6, 1e-12}) {
    Vectors v = before;
    const auto solved = solve_implicitly(block.sweep(), v, tolerance, 1);
    CAPTURE(tolerance, solved.iterations);
    CHECK(solved.iterations > 0);
    CHECK(solved.residual <= tolerance);
    CHECK((v.reshaped().matrix() - exact).norm() <= tolerance * v.matrix().norm());
  }
}

TEST_CASE("without walls the implicit step keeps momentum to rounding, however coarsely it solves",
          "[stage5]") {
  const double tolerance = GENERATE(0.1, 1e-6);
  const auto before_and_after = [&](auto block) {
    const auto before = momenta(block.particles);
    Vectors& v = block.particles.velocity;
    const double energy = product(v, v);
    REQUIRE(solve_implicitly(block.sweep(), v, tolerance, 1).iterations > 0);
    CHECK(product(v, v) < energy);
    return std::pair(before, momenta(block.particles));
  };
  // Rounding grows with the condition of the matrix, some hundred here.
  const auto check_linear = [](const Momenta& before, const Momenta& after) {
    CHECK(norm(after.linear - before.linear) < 1e-12 * before.magnitude);
  };
  const auto [before, after] = before_and_after(Block<NewtonianViscosity>(false));
  check_linear(before, after);
  CHECK(std::abs(after.angular - before.angular) < 1e-12 * before.angular_magnitude);
  // Friction along the difference of velocities brakes what turns.
  const auto [fast, slow] = before_and_after(Block<LaminarViscosity>(false));
  check_linear(fast, slow);
  CHECK(std::abs(slow.angular - fast.angular) > 1e-3 * fast.angular_magnitude);
}

TEST_CASE("a step of friction that is as short as explicit friction's comes to the same, to order dt^2",
          "[stage5]") {
  Block<NewtonianViscosity> block(true);
  std::vector<double> differences;
  const std::vector<long> parts{2000, 4000, 8000};
  for (const long part : parts) {
    block.dt = 20 * block.fluid.h * block.fluid.h / block.law.friction.nu / static_cast<double>(part);
    const Vectors before = block.particles.velocity, forward = before + block.change(before);
    Vectors backward = before;
    solve_implicitly(block.sweep(), backward, 1e-12, 1);
    differences.push_back((forward - backward).matrix().norm());
  }
  CHECK(slope(parts, differences) == Approx(2).epsilon(0.05));
}

TEST_CASE("with implicit friction, too, water between plates follows the series solution within 2 %",
          "[stage5]") {
  const std::string name = GENERATE("poiseuille", "couette");
  Simulation channel(stage5::stage().scene(name), typed({{"viscous_step", "implicit"}}));
  for (const double t : {0.0225, 0.045, 0.1125, 0.225}) {  // Morris, Fox & Zhu 1997
    run_until(channel, t);
    CAPTURE(name, t);
    CHECK(channel.error() < 0.02);
    CHECK(measure(channel, "viscous_residual") <= 1e-5);
  }
  CHECK(channel.steps() < 120);  // of 2,000 that explicit friction takes
}

TEST_CASE("implicit friction comes to the profile of explicit friction, in proportion to dt", "[stage5]") {
  constexpr double t = 0.05;
  const auto speeds = [&](const Overrides& values) {
    Simulation channel(stage5::stage().scene("couette"), values);
    run_to(channel, t);
    return Column(channel.particles().velocity.col(0));
  };
  const Column explicit_speeds = speeds({});
  std::vector<double> differences;
  const std::vector<long> steps{10, 20, 40};
  for (const long count : steps)
    differences.push_back(
        (speeds(typed({{"viscous_step", "implicit"}}, t, count)) - explicit_speeds).matrix().norm());
  // Backward Euler is of order 1. The means of the velocity that walls mirror differ a little (W, or the
  // friction itself), so a difference remains.
  CHECK(slope(steps, differences) == Approx(1).margin(0.25));
}

namespace {

/// Honey in a thread of four particles across.
Simulation poured(Values more = {}, int threads = 1) {
  more.insert(more.end(), {{"spacing", 0.001}, {"thread_length", 0.15}});
  return Simulation(stage5::stage().scene("honey"), typed(more), default_integrator, threads);
}

/// From low above the dish, so that it lands soon.
const Values soon{{"fall_height", 0.01}};

/// How often the thread, half-way down, goes from one side to the other by more than `least`.
int turns(Simulation& honey, double until, double least) {
  int count = 0;
  double side = 0;
  while (honey.time() < until) {
    honey.step(until);
    const double sway = measure(honey, "sway");
    if (std::abs(sway) < least / 2 || sway * side > 0) continue;
    if (side != 0) ++count;
    side = sway;
  }
  return count;
}

}  // namespace

TEST_CASE("poured honey folds, and all energy that it loses is counted", "[stage5]") {
  auto honey = poured();
  const auto start = honey.energy();
  CHECK(turns(honey, 0.3, 0.001) >= 2);  // a quarter of the thread's width
  const auto end = honey.energy();
  CHECK(end.mechanical() < 0.7 * start.mechanical());
  // The step of the liquid itself closes the budget to about 1e-4; the solve adds nothing to it.
  CHECK(end.total() == Approx(start.total()).epsilon(1e-3));
}

TEST_CASE("a thread with Re above 0.56 spreads without folding", "[stage5]") {
  auto thin = poured({{"nu", 0.001}});  // Re = 2
  CHECK(turns(thin, 0.3, 0.001) == 0);
}

TEST_CASE("any number of threads pours the same honey, bit for bit", "[stage5]") {
  auto one = poured(soon), two = poured(soon, 2);
  REQUIRE(one.particles().size() > block_size);
  for (auto* honey : {&one, &two}) run_until(*honey, 0.04);  // the thread has landed
  CHECK(same_fluid(one, two));
}

TEST_CASE("after a divergence honey stands on the last good state, bit for bit", "[stage5]") {
  auto lost = poured(soon), twin = poured(soon);
  for (auto* honey : {&lost, &twin}) {
    run_until(*honey, 0.04);
    run_steps(*honey, 7);
  }
  SECTION("of a velocity beyond all bounds") { lost.system().velocity(7, 1) = 1e30; }
  SECTION("of one that is no number") {
    lost.system().velocity(7, 1) = std::numeric_limits<double>::quiet_NaN();
  }
  CHECK(run_until_divergence(lost, 1).step == twin.steps() + 1);
  CHECK(same_fluid(lost, twin));
  run_steps(lost, 20);
  run_steps(twin, 20);
  CHECK(same_fluid(lost, twin));
}
