#pragma once

#include <vector>

#include "common/runner/comparison.hpp"
#include "common/runner/describe.hpp"
#include "common/runner/sheet.hpp"

namespace clapotis {

/// The differences of a comparison over time, one for each of its rows.
class Distances {
 public:
  void add(const Comparison& comparison);
  [[nodiscard]] const std::vector<Difference>& kept() const { return kept_.kept(); }

 private:
  Thinned<Difference> kept_;
};

/// Under both: their energies; their errors, where there is a reference; their difference, where it is
/// defined.
std::vector<Plot> compare_plots(const Distances& distances, const Side& left, const Side& right);

/// One side as it stands, what it costs below its title `what`, in its own colour of the plots; and why it
/// stopped, if it has.
Picture describe_side(Side& side, const std::string& what, Colour mark, const Viewpoint& viewpoint);
/// Gives two such pictures one range of colours, to which a side that has diverged adds nothing.
void share_colours(Picture& left_picture, Picture& right_picture, const Side& left, const Side& right);
/// The right one of two such pictures, and what stands above both.
Beside beside(const Side& left, const Side& right, Picture right_picture, double time);
inline Colour left_colour() { return ink::palette().curves[0]; }
inline Colour right_colour() { return ink::palette().curves[1]; }

}  // namespace clapotis
