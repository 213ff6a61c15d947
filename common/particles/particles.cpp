#include "common/particles/particles.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>
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
  const bool dense = size() > 0 ? density.size() > 0 : dense_;
  if (dense) all.push_back({"density", "kg/L^3", density});
  if (dense) all.push_back({"pressure", "kg/(L s^2)", pressure});
  for (const auto& c : extra) all.push_back({c.name, c.unit, c.values});
  return all;
}

double Particles::least_mass() const {
  return masses_ == none || size() == 0 ? uniform_mass : extra[masses_].values.minCoeff();
}

double Particles::greatest_mass() const {
  return masses_ == none || size() == 0 ? uniform_mass : extra[masses_].values.maxCoeff();
}

std::optional<Index> Particles::place_of(Index id) const {
  if (ids_.empty()) return id < size() ? std::optional(id) : std::nullopt;
  const auto found = std::lower_bound(ids_.begin(), ids_.end(), id);
  if (found == ids_.end() || *found != id) return std::nullopt;
  return static_cast<Index>(found - ids_.begin());
}

/// Where nobody is left, one cannot see which columns there were.
void Particles::note_columns() {
  if (size() == 0) return;
  dense_ = density.size() > 0;
  rated_ = density_rate.size() > 0;
}

/// From now on ids are stored.
void Particles::number() {
  if (next_id_ > 0) return;
  ids_.resize(static_cast<std::size_t>(size()));
  std::iota(ids_.begin(), ids_.end(), 0);
  next_id_ = size();
}

Index Particles::append(Index count) {
  number();
  note_columns();
  const Index before = size();
  each_column([&](auto& column, bool exists) {
    if (!exists) return;
    column.conservativeResize(before + count, Eigen::NoChange);
    column.bottomRows(count).setZero();
  });
  for (Index k = 0; k < count; ++k) ids_.push_back(next_id_++);
  return before;
}

void Particles::keep(const std::vector<char>& stays) {
  number();
  std::vector<Index> kept;
  for (std::size_t i = 0; i < stays.size(); ++i)
    if (stays[i] != 0) kept.push_back(static_cast<Index>(i));
  const Index left = static_cast<Index>(kept.size());
  const auto close_up = [&](const auto& row_of) {
    for (Index k = 0; k < left; ++k) row_of(k, kept[static_cast<std::size_t>(k)]);
  };
  note_columns();
  each_column([&](auto& column, bool exists) {
    if (!exists) return;
    close_up([&](Index to, Index from) { column.row(to) = column.row(from); });
    column.conservativeResize(left, Eigen::NoChange);
  });
  close_up([&](Index to, Index from) {
    ids_[static_cast<std::size_t>(to)] = ids_[static_cast<std::size_t>(from)];
  });
  ids_.resize(kept.size());
}

std::size_t Particles::bytes() const {
  const auto per_particle = 3 * 2 + extra.size();
  return (static_cast<std::size_t>(size()) * per_particle +
          static_cast<std::size_t>(density.size() + density_rate.size() + pressure.size())) *
             sizeof(double) +
         ids_.size() * sizeof(ids_.front());
}

}  // namespace clapotis
