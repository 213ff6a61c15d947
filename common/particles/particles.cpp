#include "common/particles/particles.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "common/particles/parallel.hpp"

namespace clapotis {

double greatest_norm(const Vectors& a, int threads) {
  const auto squares =
      of_blocks(a.rows(), threads_for_little(a.rows(), threads), [&](Index first, Index count) {
        return a.middleRows(first, count).square().rowwise().sum().maxCoeff<Eigen::PropagateNaN>();
      });
  double most = 0;
  for (const double square : squares) most = std::isnan(square) || square > most ? square : most;
  return std::sqrt(most);
}

bool Particles::finite() const {
  const auto all =
      of_blocks(size(), threads_for_little(size(), threads), [&](Index first, Index count) -> char {
        return position.middleRows(first, count).allFinite() &&
               (density.size() == 0 || density.middleRows(first, count).allFinite());
      });
  return std::all_of(all.begin(), all.end(), [](char yes) { return yes != 0; });
}

Particles::Particles(Index count, double mass)
    : position(Vectors::Zero(count, 2)),
      velocity(Vectors::Zero(count, 2)),
      acceleration(Vectors::Zero(count, 2)),
      uniform_mass(mass) {}

Column& Particles::add_column(std::string name, std::string unit) {
  if (column(name) != nullptr) throw std::logic_error("the column " + name + " exists already");
  if (name == "mass") masses_ = extra.size();
  extra.push_back({std::move(name), std::move(unit), Column::Zero(size())});
  return extra.back().values;
}

const Column* Particles::column(std::string_view name) const {
  for (const auto& c : extra)
    if (c.name == name) return &c.values;
  return nullptr;
}

std::vector<Particles::View> Particles::columns() const {
  std::vector<View> all;
  if (density.size() > 0) all.push_back({"density", "kg/L^3", density});
  if (pressure.size() > 0) all.push_back({"pressure", "kg/(L s^2)", pressure});
  for (const auto& c : extra) all.push_back({c.name, c.unit, c.values});
  return all;
}

double Particles::least_mass() const {
  return masses_ == none || size() == 0 ? uniform_mass : extra[masses_].values.minCoeff();
}

double Particles::greatest_mass() const {
  return masses_ == none || size() == 0 ? uniform_mass : extra[masses_].values.maxCoeff();
}

std::size_t Particles::bytes() const {
  const auto per_particle = 3 * 2 + extra.size();
  return (static_cast<std::size_t>(size()) * per_particle +
          static_cast<std::size_t>(density.size() + density_rate.size() + pressure.size())) *
         sizeof(double);
}

}  // namespace clapotis
