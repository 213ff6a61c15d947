#include "common/particles/particles.hpp"

#include <cmath>
#include <stdexcept>

namespace clapotis {

double greatest_norm(const Vectors& a) {
  return a.rows() == 0 ? 0 : std::sqrt(a.square().rowwise().sum().maxCoeff<Eigen::PropagateNaN>());
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
