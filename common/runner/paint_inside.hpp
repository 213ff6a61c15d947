#pragma once

#include <vector>

#include "common/runner/picture.hpp"

namespace clapotis {

// What is seen of the chosen particle of a picture. Each does nothing where there is none.

/// The cells that were looked through for its neighbours: below the particles.
void paint_visited_cells(Canvas& canvas, const Picture& picture, const PictureView& view);
/// Around itself, those near it and those that were tested in vain.
void add_chosen_rings(const Picture& picture, const PictureView& view, std::vector<Disc>& rings);
/// Its disc of support.
void paint_support(Canvas& canvas, const Picture& picture, const PictureView& view);
/// What acts on it, all arrows to one scale.
void paint_forces(Canvas& canvas, const Picture& picture, const PictureView& view);
/// The table of its values, on the side of the scene that is away from it.
void paint_facts(Canvas& canvas, const Picture& picture, const PictureView& view);

}  // namespace clapotis
