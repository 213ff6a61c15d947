#pragma once

#include "common/simulation/fluid_columns.hpp"
#include "common/simulation/model.hpp"

namespace clapotis {

/// A plane that repeats itself along x, y or both; 0 where it does not.
struct Period {
  Vector corner{0, 0};  ///< lower left of the cell that repeats [L]
  Vector length{0, 0};  ///< [L]

  /// Brings back what has left the cell.
  void wrap(Vectors& position) const;
};

/// The particles of a fluid in the order of a grid of cells. Where the plane is periodic, those near an edge
/// appear a second time, as images beyond the opposite edge, which are seen but do not see.
class FluidArrangement {
 public:
  FluidArrangement(double support, const Period& period) : support_(support), period_(period) {}

  CellGrid grid{8};
  FluidColumns columns;

  /// Sorts, and brings positions and velocities along.
  void build(const Particles& particles, int threads);
  void gather_density(const Column& density, double instead, int threads);

  [[nodiscard]] Index slots() const { return count_ + static_cast<Index>(images_.size()); }
  [[nodiscard]] bool is_image(Index slot) const { return grid.id(slot) >= count_; }
  /// The particle in a slot, or the one whose image it is.
  [[nodiscard]] Index id(Index slot) const {
    const Index k = grid.id(slot);
    return k < count_ ? k : images_[static_cast<std::size_t>(k - count_)];
  }
  [[nodiscard]] const Period& period() const { return period_; }

  [[nodiscard]] Neighbourhood neighbourhood(const Vector& r, Index i) const;
  [[nodiscard]] PairCount count_pairs() const;
  [[nodiscard]] std::size_t bytes() const;

 private:
  void add_images(int axis);

  double support_;
  Period period_;
  Index count_ = 0;
  Vectors places_;                    ///< of particles and images, where the plane is periodic
  std::vector<std::int32_t> images_;  ///< whose image each is
};

}  // namespace clapotis
