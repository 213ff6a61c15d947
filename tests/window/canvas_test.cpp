#include <cairo/cairo.h>

#include <cmath>
#include <cstdlib>
#include <memory>

#include "tests/catch.hpp"
#include "tests/window/desk.hpp"
#include "tests/window/example_sheet.hpp"

using namespace clapotis;
using clapotis::testing::Desk;

namespace {

using Image = std::unique_ptr<cairo_surface_t, void (*)(cairo_surface_t*)>;

Image load(const std::filesystem::path& file) {
  return {cairo_image_surface_create_from_png(file.c_str()), cairo_surface_destroy};
}

constexpr int tile = 16;  // pixels

/// Mean of red, green or blue over a tile, 0 to 255.
double mean(const Image& image, int left, int top, int byte) {
  const auto* pixels = cairo_image_surface_get_data(image.get());
  const int stride = cairo_image_surface_get_stride(image.get());
  double sum = 0;
  for (int y = top; y < top + tile; ++y) {
    for (int x = left; x < left + tile; ++x) sum += pixels[y * stride + 4 * x + byte];
  }
  return sum / (tile * tile);
}

}  // namespace

TEST_CASE("a sheet looks the same in the window and in a file", "[window]") {
  Desk desk("canvas");
  desk.start({CANVAS_PROBE});
  desk.await("painted");
  desk.await("painted");  // the first one may have been painted where the window was before it was moved
  const auto seen = load(desk.picture("window"));
  const testing::ExampleSheet sheet;
  const auto file = desk.folder() / "file.png";
  write_sheet(file, sheet.picture, sheet.plots);
  const auto expected = load(file);
  // The two draw the edges of letters differently and space them by a pixel or two more or less per line;
  // over a tile that evens out. A shape, a colour or a place that is wrong does not.
  double sum = 0;
  int tiles = 0, different = 0;
  for (int y = 0; y + tile <= 720; y += tile) {
    for (int x = 0; x + tile <= 1280; x += tile) {
      double worst = 0;
      for (int byte = 0; byte < 3; ++byte) {
        worst = std::max(worst, std::abs(mean(seen, x, y, byte) - mean(expected, x, y, byte)));
      }
      sum += worst;
      different += worst > 24;
      ++tiles;
    }
  }
  CHECK(sum / tiles < 2.5);
  CHECK(different < 0.01 * tiles);
}
