#include "report/studies/pressed_row.hpp"

#include <cmath>
#include <numbers>

#include "report/studies/measured.hpp"

namespace clapotis::studies {
namespace {

constexpr double overlap = 1;       // [px]
constexpr double kick = 0.2;        // largest speed at the start [px/s]
constexpr double immovable = 1e12;  // [kg]: moves by a rounding error

void arrange(System& s, int discs, double radius) {
  auto& p = s.particles;
  p.append(discs + 2 - p.size());
  auto& mass = p.extra.front().values;  // all that scene pair stores besides
  for (Index i = 0; i < p.size(); ++i) {
    const bool end = i == 0 || i == p.size() - 1;
    p.position.row(i) << 5 * radius + (2 * radius - overlap) * static_cast<double>(i), 5 * radius;
    const double share = std::fmod(static_cast<double>(i) * std::numbers::phi, 1.0);  // as if at random
    p.velocity.row(i) << (end ? 0 : kick * (2 * share - 1)), 0;
    mass(i) = end ? immovable : s.particles.uniform_mass;
  }
}

}  // namespace

std::unique_ptr<Simulation> pressed_row(int discs,
                                        const std::vector<std::pair<std::string, std::string>>& values) {
  auto row = simulation(scene("stage2/pair", values));
  const double radius = row->setup().radius;
  row->edit([&](System& s) { arrange(s, discs, radius); });
  return row;
}

double highest_frequency(int discs, double stiffness, double mass) {
  return 2 * std::sqrt(stiffness / mass) * std::cos(std::numbers::pi / (2 * discs + 2));
}

}  // namespace clapotis::studies
