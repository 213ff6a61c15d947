#include "common/runner/sheet.hpp"

#include <algorithm>

#include "common/runner/cairo_canvas.hpp"
#include "common/runner/ink.hpp"

namespace clapotis {
namespace {

constexpr double strip_share = 0.29;  ///< of the sheet's height, for the plots

double scale_of(Point size) { return std::min(size.x / 1280, size.y / 720); }

/// What remains of the sheet for the scene.
Box paint_strip(Canvas& canvas, std::span<const Plot> plots) {
  const Point size = canvas.size();
  const double scale = scale_of(size), height = plots.empty() ? 0 : strip_share * size.y;
  const double top = size.y - height, width = size.x / std::max(1.0, double(plots.size()));
  canvas.rectangle({{0, 0}, size}, ink::sheet);
  for (std::size_t k = 0; k < plots.size(); ++k) {
    paint(canvas, plots[k], {{double(k) * width, top}, {width, height}}, scale);
  }
  return {{0, 0}, {size.x, top}};
}

void paint_into(Canvas& canvas, const Picture& picture, const Box& area) {
  Painter().paint(canvas, picture, fit(picture, area, scale_of(canvas.size())));
}

}  // namespace

void paint_sheet(Canvas& canvas, const Picture& picture, std::span<const Plot> plots) {
  paint_into(canvas, picture, paint_strip(canvas, plots));
}

void paint_sheet(Canvas& canvas, const Picture& left, const Picture& right, std::span<const Plot> plots) {
  const Box both = paint_strip(canvas, plots);
  const double half = both.extent.x / 2;
  paint_into(canvas, left, {both.corner, {half, both.extent.y}});
  paint_into(canvas, right, {{both.corner.x + half, both.corner.y}, {half, both.extent.y}});
  canvas.rectangle({{half - 1, both.corner.y}, {2, both.extent.y}}, ink::grid);
}

void write_sheet(const std::filesystem::path& file, const Picture& picture, std::span<const Plot> plots,
                 Point size) {
  CairoCanvas canvas(file, size);
  paint_sheet(canvas, picture, plots);
  canvas.save();
}

void write_sheet(const std::filesystem::path& file, const Picture& left, const Picture& right,
                 std::span<const Plot> plots, Point size) {
  CairoCanvas canvas(file, size);
  paint_sheet(canvas, left, right, plots);
  canvas.save();
}

}  // namespace clapotis
