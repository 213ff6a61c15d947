#include "common/runner/sheet.hpp"

#include <algorithm>

#include "common/runner/cairo_canvas.hpp"
#include "common/runner/ink.hpp"
#include "common/runner/legend.hpp"

namespace clapotis {
namespace {

constexpr double strip_share = 0.29;   ///< of the sheet's height, for plots below the scene
constexpr double column_share = 0.38;  ///< of the sheet's width, for plots beside it

double scale_of(Point size) { return std::min(size.x / 1280, size.y / 720); }

/// A sheet cut in two: the scene, and its plots in a strip below or in a column to the right.
struct Layout {
  Box scene;
  Box plots;
  bool column;

  [[nodiscard]] Box plot(std::size_t k, std::size_t count) const {
    const double share = 1 / static_cast<double>(count), at = static_cast<double>(k) * share;
    const auto [corner, extent] = plots;
    return column ? Box{{corner.x, corner.y + at * extent.y}, {extent.x, share * extent.y}}
                  : Box{{corner.x + at * extent.x, corner.y}, {share * extent.x, extent.y}};
  }
};

Layout plots_below(Point size, bool any) {
  const double top = any ? (1 - strip_share) * size.y : size.y;
  return {.scene = {{0, 0}, {size.x, top}}, .plots = {{0, top}, {size.x, size.y - top}}, .column = false};
}

Layout plots_beside(Point size) {
  const double left = (1 - column_share) * size.x;
  return {.scene = {{0, 0}, {left, size.y}}, .plots = {{left, 0}, {size.x - left, size.y}}, .column = true};
}

/// Where the scene is larger.
Layout best_layout(const Picture& picture, Point size, bool any_plots) {
  const auto below = plots_below(size, any_plots), beside = plots_beside(size);
  if (!any_plots) return below;
  const auto zoom = [&](const Layout& layout) {
    return fit(picture, layout.scene, scale_of(size)).pixels_per_unit;
  };
  return zoom(beside) > zoom(below) ? beside : below;
}

void paint_plots(Canvas& canvas, const Layout& layout, std::span<const Plot> plots) {
  canvas.rectangle({{0, 0}, canvas.size()}, ink::sheet);
  for (std::size_t k = 0; k < plots.size(); ++k)
    paint(canvas, plots[k], layout.plot(k, plots.size()), scale_of(canvas.size()));
}

void paint_into(Canvas& canvas, const Picture& picture, const Box& area) {
  Painter().paint(canvas, picture, fit(picture, area, scale_of(canvas.size())));
}

}  // namespace

void paint_sheet(Canvas& canvas, const Picture& picture, std::span<const Plot> plots) {
  const auto layout = best_layout(picture, canvas.size(), !plots.empty());
  paint_plots(canvas, layout, plots);
  paint_into(canvas, picture, layout.scene);
}

SplitArea split(const Box& area, const Picture& left, double scale) {
  const auto [corner, extent] = area;
  const double header = header_height(extent.x, scale, left.value.size() > 0), half = extent.x / 2;
  const double top = corner.y + header, height = std::max(1.0, extent.y - header);
  return {.header = {corner, {extent.x, header}},
          .left = {{corner.x, top}, {half, height}},
          .right = {{corner.x + half, top}, {half, height}}};
}

void paint_frame(Canvas& canvas, const Picture& left, const Beside& beside, const SplitArea& area,
                 double scale) {
  canvas.rectangle(area.header, ink::sheet);
  paint_common_header(canvas, beside.title, beside.subtitle, left,
                      {.area = area.header, .scene = area.header, .scale = scale});
  const double width = 2 * scale;
  canvas.rectangle({{area.right.corner.x - width / 2, area.right.corner.y}, {width, area.right.extent.y}},
                   ink::grid);
}

void paint_sheet(Canvas& canvas, const Picture& left, const Beside& beside, std::span<const Plot> plots) {
  const auto layout = plots_below(canvas.size(), !plots.empty());
  const double scale = scale_of(canvas.size());
  paint_plots(canvas, layout, plots);
  const auto area = split(layout.scene, left, scale);
  paint_into(canvas, left, area.left);
  paint_into(canvas, beside.right, area.right);
  paint_frame(canvas, left, beside, area, scale);
}

void write_sheet(const std::filesystem::path& file, const Picture& picture, std::span<const Plot> plots,
                 Point size) {
  CairoCanvas canvas(file, size);
  paint_sheet(canvas, picture, plots);
  canvas.save();
}

void write_sheet(const std::filesystem::path& file, const Picture& left, const Beside& beside,
                 std::span<const Plot> plots, Point size) {
  CairoCanvas canvas(file, size);
  paint_sheet(canvas, left, beside, plots);
  canvas.save();
}

}  // namespace clapotis
