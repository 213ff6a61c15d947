#pragma once

#include "common/particles/period.hpp"
#include "common/simulation/fluid_columns.hpp"

namespace clapotis {

/// Walls made of particles at rest, as dense as the fluid and as many layers deep as its support, which push
/// back with the pressure that the fluid beside them has (Adami, Hu & Adams 2012):
///
///   p_w = sum_f (p_f + rho_f g.(x_w - x_f)) W / sum_f W,
///
/// not below 0 where the fluid bears no tension. Their density stays rho_0, so that a wall remembers nothing:
/// by Adami it follows from p_w, which changes it by the compression, 0.25 % at the bottom of a tank. Where
/// nothing is slipping along them, they carry the velocity 2 v_w - sum_f v_f W / sum_f W, v_w their own: a
/// wall may slide along itself, its particles standing where they are.
struct DummyWalls {
  Vectors places;  ///< of the particles, images included [L]
  FluidColumns columns;
  CellGrid grid;

  DummyWalls() = default;
  /// `support` is the kernel's [L]. Where the plane is periodic, those near an edge appear beyond the other
  /// one too.
  DummyWalls(const Vectors& particles, const Fluid& fluid, double support, const Period& period = {});

  [[nodiscard]] Index size() const { return places.rows(); }
  /// Lets slide, at `speed` along x [L/s], those above y.
  void slide_above(double y, double speed);
  [[nodiscard]] auto own_velocity(auto at) const {
    const auto along = load(sliding_.data(), at);
    return Vec{along, decltype(along)(0.0)};
  }
  /// Gives the images the pressure and the velocity of what they are images of.
  void copy_to_images();
  /// Whether a particle of the wall may be within the support of r: quick, and right for almost all that are
  /// far from walls.
  [[nodiscard]] bool near(const Vector& r) const {
    const double column = (r.x - corner_.x) * inverse_side_, line = (r.y - corner_.y) * inverse_side_;
    if (!(column >= 0 && line >= 0 && column < columns_ && line < lines_)) return false;
    return reached_[static_cast<std::size_t>(line) * static_cast<std::size_t>(columns_) +
                    static_cast<std::size_t>(column)] != 0;
  }
  [[nodiscard]] std::size_t bytes() const;

 private:
  void mark_reached(double support);

  struct Copy {
    Index image, source;  ///< slots
  };
  std::vector<Copy> images_;
  Column sliding_;  ///< speed of each along x [L/s], as long as `columns`
  Vector corner_{0, 0};
  double inverse_side_ = 0, columns_ = 0, lines_ = 0;  ///< of square cells of one support
  std::vector<std::uint8_t> reached_;                  ///< whether a cell is within reach of the wall
};

/// How many layers of particles, `spacing` apart, a wall needs so that no neighbour is missing [L].
Index wall_layers(double spacing, double support);
/// How thick it is then [L].
double wall_thickness(double spacing, double support);

/// Where the particles of a tank's floor and side walls stand: a lattice of spacing dx around `inside`, its
/// first layer half a spacing outside, as many layers as the support needs. The walls rise to `top`.
Vectors tank_walls(double left, double right, double bottom, double top, double spacing, double support);

}  // namespace clapotis
