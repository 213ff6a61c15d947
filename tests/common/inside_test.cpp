// What a model tells of one particle: the share of each law, what the kernel weighs.

#include <algorithm>
#include <cmath>
#include <string>

#include "common/simulation/simulation.hpp"
#include "stage1_bouncing/scenes.hpp"
#include "stage2_cloud/scenes.hpp"
#include "stage3_grid/scenes.hpp"
#include "stage4_sph/scenes.hpp"
#include "stage5_extensions/scenes.hpp"
#include "tests/catch.hpp"
#include "tests/stage4/state.hpp"

using namespace clapotis;
using namespace clapotis::tests;

namespace {

constexpr std::string_view implicit = "implicit_viscosity";

/// The sum over the explicit laws, and how large the largest of them is.
struct Shares {
  Vector sum{0, 0};
  double largest = 0;
};
Shares explicit_shares(const System& s, Index i) {
  Shares shares;
  for (const auto& [name, a] : s.model.accelerations_by_law(s, i)) {
    if (name == implicit) continue;
    shares.sum += a;
    shares.largest = std::max(shares.largest, norm(a));
  }
  return shares;
}

/// The largest error of the sum over laws among some of the particles, relative to the largest acceleration
/// by a law: that of one particle may be what is left of forces that cancel.
double largest_error(Simulation& simulation) {
  double worst = 0, most = 0;
  simulation.look([&](const System& s) {
    const Index n = s.particles.size(), stride = std::max<Index>(1, n / 97);
    for (Index i = 0; i < n; i += stride) {
      const auto [sum, largest] = explicit_shares(s, i);
      worst = std::max(worst, norm(sum - row(s.acceleration, i)));
      most = std::max(most, largest);
    }
  });
  return worst > 0 ? worst / most : 0;
}

std::vector<Stage> all_stages() {
  return {stage1::stage(), stage2::stage(), stage3::stage(), stage4::stage(), stage5::stage()};
}

}  // namespace

TEST_CASE("what the laws give a particle adds up to its acceleration, in every scene of every stage",
          "[inside]") {
  for (const auto& stage : all_stages())
    for (const auto& scene : stage.scenes) {
      CAPTURE(stage.name, scene.name);
      Simulation simulation(scene);
      for (int k = 0; k < 3; ++k) simulation.step();
      CHECK(largest_error(simulation) < 1e-12);
    }
}

TEST_CASE("so it does in a crowd that is pressed together, with all formulations of a liquid", "[inside]") {
  Simulation crowd(stage3::stage().scene("cloud"), typed({{"particles", 400.0}, {"y0", 0.0}}));
  run_to(crowd, 1.0);
  CHECK(largest_error(crowd) < 1e-12);
  for (const char* density : {"continuity", "summation"}) {
    Simulation water(stage4::stage().scene("dam_break"),
                     typed({{"spacing", 0.05}, {"density", density}, {"nu", 0.05}, {"slip", "no"}}));
    run_to(water, 0.3);
    CAPTURE(density);
    CHECK(largest_error(water) < 1e-12);
  }
}

TEST_CASE("an implicit law's share is what it did to the velocity in the step that has just ended",
          "[inside]") {
  Simulation honey(stage5::stage().scene("honey"), typed({{"viscous_tolerance", 1e-13}}), "symplectic_euler");
  auto& start = honey.system();
  start.position.col(1) -= honey.parameters().value("fall_height") / 2;  // some of it out of the nozzle
  start.velocity.col(0) += 5 * start.position.col(1);                    // sheared
  for (int k = 0; k < 2; ++k) honey.step();
  const auto& p = honey.particles();
  Vectors before = p.velocity, explicit_share(p.size(), 2);
  const double mouth = honey.parameters().value("fall_height"), dt = honey.dt();
  honey.look([&](const System& s) { explicit_share = s.acceleration; });
  honey.step();
  double worst = 0, most = 0;
  honey.look([&](const System& s) {
    for (Index i = 0; i < p.size(); i += 7) {
      if (p.position(i, 1) > mouth - 0.01) continue;  // the nozzle holds what is in it
      const Vector change = 1 / dt * (row(p.velocity, i) - row(before, i)) - row(explicit_share, i);
      const auto laws = s.model.accelerations_by_law(s, i);
      const auto viscous = std::ranges::find(laws, implicit, &ActingLaw::name);
      REQUIRE(viscous != laws.end());
      worst = std::max(worst, norm(viscous->acceleration - change));
      most = std::max(most, norm(change));
    }
  });
  CHECK(most > 0.1);
  CHECK(worst < 1e-6 * most);
}

TEST_CASE("nothing acts on a particle that an open end holds, all laws on one in the flow", "[inside]") {
  Simulation jet(stage5::stage().scene("jet"), typed({{"spacing", 0.01}}));
  for (int k = 0; k < 5; ++k) jet.step();
  Index held = 0, free = 0;
  jet.look([&](const System& s) {
    for (Index i = 0; i < s.particles.size(); i += 3) {
      const bool acts = explicit_shares(s, i).largest > 0;
      ++(acts ? free : held);
      if (!acts) CHECK(row(s.acceleration, i) == Vector{0, 0});
    }
  });
  CHECK(held > 10);
  CHECK(free > 10);
}

TEST_CASE("looking inside a particle does not change where anything goes", "[inside]") {
  const std::pair<Stage, std::string> watched_scenes[] = {{stage1::stage(), "drop"},
                                                          {stage3::stage(), "cloud"},
                                                          {stage4::stage(), "dam_break"},
                                                          {stage4::stage(), "elliptical_drop"},
                                                          {stage5::stage(), "honey"}};
  for (const auto& [stage, name] : watched_scenes) {
    CAPTURE(stage.name, name);
    const Scene scene = stage.scene(name);
    Simulation alone(scene), watched(scene);
    for (int step = 0; step < 30; ++step) {
      alone.step();
      watched.step();
      watched.look([&](const System& s) {
        const Index i = step % s.particles.size();
        CHECK_FALSE(s.model.accelerations_by_law(s, i).empty());
        static_cast<void>(s.model.kernel_around(i));
        static_cast<void>(s.model.push_at(1, i));
      });
    }
    CHECK(same_fluid(alone, watched));
  }
}

TEST_CASE("the neighbours that the kernel weighs give the density that the scene computes with", "[inside]") {
  for (const char* kernel : {"wendland_c2", "cubic_spline"}) {
    Simulation water(stage4::stage().scene("dam_break"),
                     typed({{"spacing", 0.05}, {"density", "summation"}, {"kernel", kernel}}));
    run_to(water, 0.2);
    long walls = 0;
    water.look([&](const System& s) {
      for (Index i = 0; i < s.particles.size(); i += 5) {
        const auto around = s.model.kernel_around(i);
        REQUIRE(around);
        double sum = 0;
        for (const auto& [d, volume, wall] : around->neighbours) {
          sum += around->value(norm(d));
          walls += wall ? 1 : 0;
          CHECK(norm(d) < around->support);
        }
        CHECK(sum * water.setup().fluid->mass == Approx(s.density(i)).epsilon(1e-12));
      }
      const auto around = *s.model.kernel_around(0);
      for (const double r : {0.3, 0.9, 1.1, 1.9}) {
        const double at = r * around.h, step = 1e-5 * around.h;
        CHECK(around.slope(at) ==
              Approx((around.value(at + step) - around.value(at - step)) / (2 * step)).epsilon(1e-6));
      }
      CHECK(around.slope(0) == 0);
    });
    CHECK(walls > 20);
  }
}

TEST_CASE("two discs push each other as the law of contact says, and a scene without one has no push",
          "[inside]") {
  Simulation pair(stage2::stage().scene("pair"));
  const double k = pair.parameters().value("stiffness"), h = pair.parameters().value("radius");
  const double m = pair.particles().mass(0);
  pair.look([&](const System& s) {
    CHECK(s.model.push_at(1.5 * h, 0) == Approx(k / m * 0.5 * h).epsilon(1e-12));
    CHECK(s.model.push_at(2 * h, 0) == 0);
    CHECK(s.model.push_at(3 * h, 0) == 0);
    CHECK_FALSE(s.model.kernel_around(0));
  });
  Simulation drop(stage1::stage().scene("drop"));
  drop.look([](const System& s) { CHECK(s.model.push_at(0.1, 0) == 0); });
}

TEST_CASE("the cells that are shown as visited hold just the candidates that were tested", "[inside]") {
  Simulation water(stage4::stage().scene("dam_break"), typed({{"spacing", 0.05}}));
  Simulation discs(stage3::stage().scene("cloud"));
  for (auto* simulation : {&discs, &water}) {
    const auto& p = simulation->particles();
    for (Index i = 0; i < p.size(); i += 11) {
      const auto near = *simulation->model().neighbourhood(p, i);
      const auto& [low, high] = near.visited;
      std::size_t inside = 0;
      for (Index j = 0; j < p.size(); ++j) {
        const Vector r = row(p.position, j);
        inside += r.x >= low.x && r.x < high.x && r.y >= low.y && r.y < high.y ? 1 : 0;
      }
      CHECK(inside == near.candidates.size() + 1);  // itself
    }
  }
  Simulation all_pairs(stage2::stage().scene("cloud"));
  const auto near = *all_pairs.model().neighbourhood(all_pairs.particles(), 3);
  CHECK(near.visited.low == near.visited.high);
}
