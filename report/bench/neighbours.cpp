#include <fmt/core.h>

#include <cmath>

#include "report/bench/timed.hpp"
#include "stage2_cloud/scenes.hpp"
#include "stage3_grid/scenes.hpp"

namespace clapotis::bench {
namespace {

struct Row {
  long n;
  double seconds;
};

double exponent(const Row& a, const Row& b) {
  return std::log(b.seconds / a.seconds) / std::log(static_cast<double>(b.n) / static_cast<double>(a.n));
}

std::vector<Row> sweep(const Stage& stage, const std::vector<long>& counts) {
  std::vector<Row> rows;
  for (const long n : counts) {
    auto cloud = packed_cloud(stage.scene("cloud"), n);
    rows.push_back({n, step_seconds(fmt::format("{}: a step of {} discs", stage.name, n), *cloud)});
  }
  return rows;
}

void print(const Stage& stage, const std::vector<Row>& rows) {
  fmt::print("\n{:>16} {:>9} {:>12} {:>10} {:>9}\n", stage.name, "n", "ms per step", "M upd/s", "exponent");
  for (std::size_t k = 0; k < rows.size(); ++k)
    fmt::print("{:>16} {:>9} {:>12.4f} {:>10.2f} {:>9}\n", "", rows[k].n, 1e3 * rows[k].seconds,
               1e-6 * static_cast<double>(rows[k].n) / rows[k].seconds,
               k > 0 ? fmt::format("{:.2f}", exponent(rows[k - 1], rows[k])) : "");
}

}  // namespace

TEST_CASE("cost of a step against n, all pairs and grid, one core", "[neighbours]") {
  const auto list = sweep(stage2::stage(), {10, 30, 100, 300, 1000, 3000, 10000});
  const auto grid = sweep(stage3::stage(), {10, 30, 100, 300, 1000, 3000, 10000, 100000, 1000000});
  print(stage2::stage(), list);
  print(stage3::stage(), grid);
  for (std::size_t k = 0; k + 1 < list.size(); ++k) {
    const double before = list[k].seconds / grid[k].seconds,
                 after = list[k + 1].seconds / grid[k + 1].seconds;
    if (before < 1 && after >= 1) {
      const double share = std::log(1 / before) / std::log(after / before);
      fmt::print("crossover: the grid is faster from n = {:.0f}\n",
                 static_cast<double>(list[k].n) *
                     std::pow(static_cast<double>(list[k + 1].n) / static_cast<double>(list[k].n), share));
    }
  }
  double fastest = 0, slowest = 1e300;
  for (const auto& row : grid)
    if (row.n >= 1000) {
      const double rate = static_cast<double>(row.n) / row.seconds;
      fastest = std::max(fastest, rate);
      slowest = std::min(slowest, rate);
    }
  fmt::print("grid, 1,000 to 1,000,000: slowest over fastest {:.2f}\n", slowest / fastest);
}

TEST_CASE("two threads against one, 100,000 discs", "[threads]") {
  auto one = packed_cloud(stage3::stage().scene("cloud"), 100000),
       two = packed_cloud(stage3::stage().scene("cloud"), 100000, 2);
  const double seconds = step_seconds("a step of 100000 discs, one thread", *one);
  const auto pairs = one->model().count_pairs(one->particles());
  fmt::print("\none thread: {:.2f} M updates/s, {:.2f} neighbours and {:.2f} candidates each\n",
             0.1 / seconds, static_cast<double>(pairs.neighbours) / 1e5,
             static_cast<double>(pairs.candidates) / 1e5);
  fmt::print("cloud, 100000 discs: two threads are {:.2f} times one\n", times_as_fast(*two, *one));
}

}  // namespace clapotis::bench
