#include "common/runner/cairo_canvas.hpp"

#include <cairo.h>
#include <unistd.h>

#include <cmath>
#include <filesystem>
#include <fstream>
#include <memory>
#include <system_error>

#include "common/runner/ink.hpp"
#include "common/runner/sheet.hpp"
#include "tests/catch.hpp"

namespace clapotis {
namespace {

namespace fs = std::filesystem;
using Catch::Matchers::ContainsSubstring;

/// A folder of this test's own, removed at its end.
struct Folder {
  fs::path path = fs::temp_directory_path() / ("clapotis-pictures-" + std::to_string(getpid()));
  Folder() { fs::create_directories(path); }
  ~Folder() { fs::remove_all(path); }
  Folder(const Folder&) = delete;
  Folder& operator=(const Folder&) = delete;
  [[nodiscard]] long entries() const {
    return std::distance(fs::directory_iterator(path), fs::directory_iterator());
  }
};

class Png {
 public:
  explicit Png(const fs::path& file)
      : surface_(cairo_image_surface_create_from_png(file.c_str()), cairo_surface_destroy) {
    REQUIRE(cairo_surface_status(surface_.get()) == CAIRO_STATUS_SUCCESS);
  }
  [[nodiscard]] int width() const { return cairo_image_surface_get_width(surface_.get()); }
  [[nodiscard]] int height() const { return cairo_image_surface_get_height(surface_.get()); }
  [[nodiscard]] Colour pixel(Point p) const {
    const auto* row = cairo_image_surface_get_data(surface_.get()) +
                      static_cast<int>(p.y) * cairo_image_surface_get_stride(surface_.get());
    const auto* bgr = row + 4 * static_cast<int>(p.x);  // little-endian 0xAARRGGBB
    return {float(bgr[2]) / 255, float(bgr[1]) / 255, float(bgr[0]) / 255};
  }

 private:
  std::unique_ptr<cairo_surface_t, void (*)(cairo_surface_t*)> surface_;
};

bool same(Colour a, Colour b) {  // up to one of 256 levels: cairo rounds down
  const auto near = [](float p, float q) { return std::abs(p - q) < 1.01F / 255; };
  return near(a.red, b.red) && near(a.green, b.green) && near(a.blue, b.blue);
}

std::string first_bytes(const fs::path& file, std::size_t count) {
  std::string bytes(count, ' ');
  std::ifstream(file, std::ios::binary).read(bytes.data(), static_cast<std::streamsize>(count));
  return bytes;
}

/// One particle at a quarter of the pressure scale near the floor, one at its top near the ceiling.
Picture tank() {
  Picture picture;
  picture.title = "Stage 4 - SPH";
  picture.upper = {2, 1};
  picture.length_unit = "m";
  picture.radius = 0.05;
  picture.x = Eigen::Array2d(0.5, 1.5);
  picture.y = Eigen::Array2d(0.1, 0.9);
  picture.value = Eigen::Array2d(2500, 10000);
  picture.colours = {"p", "Pa", 0, 10000, ColourMap::viridis};
  return picture;
}

}  // namespace

TEST_CASE("a particle in the PNG has the colour that the legend gives its value, and is where it is",
          "[pictures]") {
  const Folder folder;
  const fs::path file = folder.path / "tank.PNG";
  const Picture picture = tank();
  write_sheet(file, picture);
  const Png png(file);
  CHECK(png.width() == 1280);
  CHECK(png.height() == 720);
  const PictureView view = fit(picture, {{0, 0}, {1280, 720}});
  const Point low = view.to_pixel(0.5, 0.1), high = view.to_pixel(1.5, 0.9);
  CHECK(same(png.pixel(low), at(ColourMap::viridis, 0.25)));
  CHECK(same(png.pixel(high), at(ColourMap::viridis, 1)));
  CHECK(same(png.pixel(view.to_pixel(1.5, 0.1)), ink::paper));
  CHECK(high.y < low.y);  // y of the world grows upwards, y of the picture downwards
  CHECK(folder.entries() == 1);
}

TEST_CASE("a pressure that is no number is magenta in the PNG", "[pictures]") {
  const Folder folder;
  Picture picture = tank();
  picture.value[0] = std::nan("");
  write_sheet(folder.path / "tank.png", picture);
  const PictureView view = fit(picture, {{0, 0}, {1280, 720}});
  CHECK(same(Png(folder.path / "tank.png").pixel(view.to_pixel(0.5, 0.1)), not_a_number));
}

TEST_CASE("a ring leaves what is below visible", "[pictures]") {
  const Folder folder;
  CairoCanvas canvas(folder.path / "ring.png", {40, 40});
  const Colour red{1, 0, 0}, blue{0, 0, 1};
  canvas.rectangle({{0, 0}, {40, 40}}, blue);
  canvas.discs(std::array{Disc{{20, 20}, 15, red, 8}});
  canvas.save();
  const Png png(folder.path / "ring.png");
  CHECK(same(png.pixel({20, 20}), blue));
  CHECK(same(png.pixel({31, 20}), red));
  CHECK(same(png.pixel({38, 20}), blue));
}

TEST_CASE("Greek letters are painted as themselves", "[pictures]") {
  const Folder folder;
  const auto painted = [&](const char* letter) {
    const fs::path file = folder.path / "letter.png";
    CairoCanvas canvas(file, {40, 40});
    canvas.rectangle({{0, 0}, {40, 40}}, ink::paper);
    canvas.text({20, 30}, letter, 24, ink::text, Align::centre);
    canvas.save();
    std::string pixels;
    const Png png(file);
    for (int k = 0; k < 1600; ++k)
      pixels += png.pixel({double(k % 40), double(k / 40)}).red < 0.5F ? '#' : ' ';
    return pixels;
  };
  const std::string unknown =
      painted("\uE123");  // of the private use area: the font's sign for "no such letter"
  for (const char* letter : {"ρ", "α", "γ", "Δ"}) {
    CHECK(painted(letter) != unknown);
    CHECK(painted(letter).find('#') != std::string::npos);
  }
  CHECK(painted("ρ") != painted("α"));
}

TEST_CASE("the extension chooses the format", "[pictures]") {
  const Folder folder;
  for (const char* name : {"a.png", "a.svg", "a.pdf"}) write_sheet(folder.path / name, tank());
  CHECK(first_bytes(folder.path / "a.png", 8) == "\x89PNG\r\n\x1a\n");
  CHECK(first_bytes(folder.path / "a.svg", 5) == "<?xml");
  CHECK(first_bytes(folder.path / "a.pdf", 5) == "%PDF-");
  CHECK(folder.entries() == 3);
}

TEST_CASE("another extension is refused in a sentence that names the three", "[pictures]") {
  for (const char* name : {"a.jpg", "a", ".png"}) {
    CHECK_THROWS_WITH(picture_format(name),
                      ContainsSubstring(name) && ContainsSubstring("must end in .png, .svg or .pdf"));
  }
}

TEST_CASE("a picture of no or of boundless size is refused", "[pictures]") {
  for (const double side : {0.0, -5.0, 1e6, std::nan("")}) {
    CHECK_THROWS_AS(CairoCanvas("a.png", {1280, side}), std::invalid_argument);
  }
}

TEST_CASE("a picture that cannot be written says so and leaves nothing behind", "[pictures]") {
  const Folder folder;
  SECTION("no such folder") {
    CHECK_THROWS_WITH(write_sheet(folder.path / "absent" / "a.png", tank()),
                      ContainsSubstring("cannot write picture") && ContainsSubstring("absent/a.png") &&
                          ContainsSubstring("No such file"));
    CHECK(folder.entries() == 0);
  }
  SECTION("a file in the place of the folder") {
    std::ofstream(folder.path / "plain") << "text";
    CHECK_THROWS_AS(write_sheet(folder.path / "plain" / "a.svg", tank()), std::system_error);
    CHECK(folder.entries() == 1);
  }
  SECTION("a folder in the place of the file") {
    fs::create_directory(folder.path / "a.pdf");
    CHECK_THROWS_WITH(write_sheet(folder.path / "a.pdf", tank()),
                      ContainsSubstring("a.pdf") && ContainsSubstring("directory"));
    CHECK(folder.entries() == 1);
  }
}

TEST_CASE("a picture that is not saved leaves no file", "[pictures]") {
  const Folder folder;
  { const CairoCanvas canvas(folder.path / "a.svg", {100, 100}); }
  CHECK(folder.entries() == 0);
}

TEST_CASE("a new picture takes the place of the old one", "[pictures]") {
  const Folder folder;
  std::ofstream(folder.path / "a.png") << "old";
  write_sheet(folder.path / "a.png", tank());
  CHECK(Png(folder.path / "a.png").width() == 1280);
  CHECK(folder.entries() == 1);
}

}  // namespace clapotis
