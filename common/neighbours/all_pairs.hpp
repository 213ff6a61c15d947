#pragma once

#include <utility>

#include "common/particles/particles.hpp"

namespace clapotis {

/// Neighbours by trying every particle with every other: O(n^2), and nothing to prepare.
///
/// What a neighbour search gives: an order of the particles (slot -> id), and for each slot ranges [first,
/// last) of slots that hold at least all particles within the support, itself included.
class AllPairs {
 public:
  void build(const Vectors& position, double /*support*/, int /*threads*/) { n_ = position.rows(); }
  [[nodiscard]] Index id(Index slot) const { return slot; }
  void candidates(Vector /*r*/, auto&& visit) const { visit(Index{0}, n_); }

  [[nodiscard]] Vector cell() const { return {0, 0}; }  ///< no cells
  [[nodiscard]] Vector origin() const { return {0, 0}; }
  [[nodiscard]] static Corners visited(Vector /*r*/) { return {}; }
  [[nodiscard]] std::size_t bytes() const { return 0; }

 private:
  Index n_ = 0;
};

}  // namespace clapotis
