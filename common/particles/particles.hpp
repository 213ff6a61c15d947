#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <deque>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "common/particles/vec.hpp"

namespace clapotis {

using Index = Eigen::Index;
using Column = Eigen::ArrayXd;  ///< one number per particle: n
using Vectors =
    Eigen::Array<double, Eigen::Dynamic, 2>;  ///< one vector per particle: n x 2, all x then all y

inline Vector row(const Vectors& a, Index i) { return {a(i, 0), a(i, 1)}; }

/// A quantity that only some scenes store for each particle. In `unit`, L stands for the scene's unit of
/// length.
struct NamedColumn {
  std::string name, unit;
  Column values;
};

/// The greatest length of the vectors; NaN if any is, 0 if there are none.
double greatest_norm(const Vectors& a, int threads = 1);

/// The particles of a scene, as columns (structure of arrays). Their order is that of their ids. Position,
/// velocity and acceleration always exist, density and pressure in a fluid; `extra` holds what the laws of
/// the scene need besides. Without a column "mass" all have `uniform_mass`.
struct Particles {
  Particles() = default;
  /// `count` particles of `mass` each [kg], at the origin and at rest.
  Particles(Index count, double mass);

  Vectors position;      ///< r [L]
  Vectors velocity;      ///< v [L/s]
  Vectors acceleration;  ///< a [L/s^2]: sum of the laws at the last evaluation
  Column density;        ///< rho [kg/L^3]; empty where there is no fluid
  Column density_rate;   ///< d rho/dt; empty unless the density is advanced by the equation of continuity
  Column pressure;       ///< p of that density at the last evaluation [kg/(L s^2)]; empty without a fluid
  double uniform_mass = 1;
  int threads = 1;                 ///< that share what is done with all of them
  std::string_view kind = "disc";  ///< what they are, for files: disc, fluid
  std::deque<NamedColumn> extra;   ///< a deque: columns stay where they are when others are added

  [[nodiscard]] Index size() const { return position.rows(); }
  /// The number by which particle i is known as long as it exists: its place, until particles come or go.
  [[nodiscard]] Index id(Index i) const {
    return ids_.empty() ? i : static_cast<Index>(ids_[static_cast<std::size_t>(i)]);
  }
  /// Of all, in their order; empty as long as they are the places.
  [[nodiscard]] const std::vector<std::int64_t>& ids() const { return ids_; }
  /// The place of the particle known by `id`, if it exists.
  [[nodiscard]] std::optional<Index> place_of(Index id) const;

  /// Adds `count` particles at the end, with new ids and zeros in all columns; returns the first one's place.
  Index append(Index count);
  /// Removes the particles for which `stays` holds 0. The others keep their order.
  void keep(const std::vector<char>& stays);
  [[nodiscard]] double mass(Index i) const {
    return masses_ != none ? extra[masses_].values(i) : uniform_mass;
  }

  /// Whether all positions and densities are numbers; of the velocities `greatest_norm` tells.
  [[nodiscard]] bool finite() const;
  /// The smallest mass: what bounds the time step.
  [[nodiscard]] double least_mass() const;
  /// The largest mass: what it moves with may pass to the lightest.
  [[nodiscard]] double greatest_mass() const;

  /// Adds a column of zeros; its name must be new.
  Column& add_column(std::string name, std::string unit);
  /// The column of that name, or null.
  [[nodiscard]] const Column* column(std::string_view name) const;
  /// The columns that only some scenes have, for files and colours: density, pressure, then the extra ones.
  struct View {
    std::string_view name, unit;
    const Column& values;
  };
  [[nodiscard]] std::vector<View> columns() const;
  /// Memory of all columns [byte].
  [[nodiscard]] std::size_t bytes() const;

  /// Calls visit(x) for all columns, empty ones included, and for the ids, always in the same order: who
  /// saves them cannot forget one.
  template <class Visit>
  void pass_state(Visit&& visit) {
    each_column([&](auto& column, bool /*exists*/) { visit(column); });
    visit(ids_);
    visit(next_id_);
    visit(dense_);
    visit(rated_);
  }

 private:
  static constexpr std::size_t none = static_cast<std::size_t>(-1);
  /// Calls act(column, whether it exists) for all that there can be; one may exist where nobody has any.
  void each_column(const auto& act) {
    act(position, true);
    act(velocity, true);
    act(acceleration, true);
    act(density, dense_);
    act(density_rate, rated_);
    act(pressure, dense_);
    for (auto& c : extra) act(c.values, true);
  }
  void note_columns();
  void number();

  std::size_t masses_ = none;           ///< place of the column "mass"
  std::vector<std::int64_t> ids_;       ///< empty as long as they are the places
  std::int64_t next_id_ = 0;            ///< where `ids_` is not empty
  bool dense_ = false, rated_ = false;  ///< whether density and its rate exist, also where nobody has any
};

}  // namespace clapotis
