#pragma once

#include <Eigen/Core>
#include <deque>
#include <string>
#include <string_view>

#include "common/particles/vec.hpp"

namespace clapotis {

using Index = Eigen::Index;
using Column = Eigen::ArrayXd;  ///< one number per particle: n
using Vectors =
    Eigen::Array<double, Eigen::Dynamic, 2>;  ///< one vector per particle: n x 2, all x then all y

inline Vector row(const Vectors& a, Index i) { return {a(i, 0), a(i, 1)}; }

/// A quantity that only some scenes store for each particle.
struct NamedColumn {
  std::string name, unit;
  Column values;
};

/// The particles of a scene, as columns (structure of arrays). A particle's id is its place, 0 to n-1.
/// Position, velocity and acceleration always exist; `extra` holds what the laws of the scene need besides,
/// and drives memory, CSV headers and the list of what can be coloured. Without a column "mass" all have
/// `uniform_mass`.
struct Particles {
  Particles() = default;
  /// `count` particles of `mass` each [kg], at the origin and at rest.
  Particles(Index count, double mass);

  Vectors position;      ///< r [L]
  Vectors velocity;      ///< v [L/s]
  Vectors acceleration;  ///< a [L/s^2]: sum of the laws at the last evaluation
  double uniform_mass = 1;
  std::deque<NamedColumn> extra;  ///< a deque: columns stay where they are when others are added

  [[nodiscard]] Index size() const { return position.rows(); }
  [[nodiscard]] double mass(Index i) const {
    return masses_ != none ? extra[masses_].values(i) : uniform_mass;
  }

  /// The smallest mass: what bounds the time step.
  [[nodiscard]] double least_mass() const;
  /// The largest mass: what it moves with may pass to the lightest.
  [[nodiscard]] double greatest_mass() const;

  /// Adds a column of zeros; its name must be new.
  Column& add_column(std::string name, std::string unit);
  /// The column of that name, or null.
  [[nodiscard]] const Column* column(std::string_view name) const;
  /// Memory of all columns [byte].
  [[nodiscard]] std::size_t bytes() const;

 private:
  static constexpr std::size_t none = static_cast<std::size_t>(-1);
  std::size_t masses_ = none;  ///< place of the column "mass"
};

}  // namespace clapotis
