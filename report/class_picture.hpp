#pragma once

#include <string>
#include <typeindex>
#include <vector>

#include "common/runner/canvas.hpp"

namespace clapotis {

enum class Kind { gives, takes, derives };
struct Arrow {
  std::type_index from, to;
  Kind kind;
};

/// A law and its hooks.
struct LawLine {
  std::string name, hooks;
};

inline constexpr Point sheet_size{454, 292};  // points: 16 cm wide
inline constexpr double text_height = 7.6, small_text = 6.6, line_height = 8.8, place_width = 66;

/// One type, or several one below the other.
struct Place {
  Box box;
  std::vector<std::string> names;
  std::vector<std::type_index> types;
};

/// The boxes, and from box to box the arrows: types that share a box share their arrows.
void paint_boxes(Canvas& canvas, const std::vector<Place>& places, const std::vector<Arrow>& arrows);
/// Below each other: the laws of a model, and beside each its hooks. Returns where the table ends.
double paint_laws(Canvas& canvas, const Point& corner, const std::string& title,
                  const std::vector<LawLine>& laws);
/// What the arrows mean, along the lower edge.
void paint_key(Canvas& canvas, double left);

}  // namespace clapotis
