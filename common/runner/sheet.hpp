#pragma once

#include <filesystem>
#include <span>

#include "common/runner/picture.hpp"
#include "common/runner/plot.hpp"

namespace clapotis {

/// A whole sheet, as large as the canvas: the picture and its plots, below it or beside it, where the scene
/// is larger.
void paint_sheet(Canvas& canvas, const Picture& picture, std::span<const Plot> plots = {});

/// What makes a picture the left one of two: the other one, and what is said above both. They share the
/// colours of the left one.
struct Beside {
  std::string title, subtitle;
  Picture right;
};

/// Two pictures side by side under one title and one legend.
struct SplitArea {
  Box header, left, right;
};
[[nodiscard]] SplitArea split(const Box& area, const Picture& left, double scale);
/// What stands above both, and the line between them.
void paint_frame(Canvas& canvas, const Picture& left, const Beside& beside, const SplitArea& area,
                 double scale);

/// Two pictures side by side above the plots they share.
void paint_sheet(Canvas& canvas, const Picture& left, const Beside& beside, std::span<const Plot> plots = {});

/// Paints a sheet into a PNG, SVG or PDF file; see CairoCanvas for what it throws.
void write_sheet(const std::filesystem::path& file, const Picture& picture, std::span<const Plot> plots = {},
                 Point size = {1280, 720});
void write_sheet(const std::filesystem::path& file, const Picture& left, const Beside& beside,
                 std::span<const Plot> plots = {}, Point size = {1280, 720});

}  // namespace clapotis
