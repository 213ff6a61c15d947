#include <array>
#include <cmath>
#include <limits>
#include <random>

#include "common/runner/colour_map.hpp"
#include "common/runner/ink.hpp"
#include "common/runner/picture.hpp"
#include "common/runner/sheet.hpp"
#include "common/runner/ticks.hpp"
#include "tests/catch.hpp"
#include "tests/common/recording_canvas.hpp"

namespace clapotis {
namespace {

constexpr double nan = std::numeric_limits<double>::quiet_NaN();
constexpr Box whole{{0, 0}, {1280, 720}};

/// CIE 1976 L* of an sRGB colour, 0 (black) to 100 (white).
double lightness(Colour c) {
  const auto linear = [](float s) { return s <= 0.04045F ? s / 12.92 : std::pow((s + 0.055) / 1.055, 2.4); };
  const double y = 0.2126 * linear(c.red) + 0.7152 * linear(c.green) + 0.0722 * linear(c.blue);
  return y > 0.008856 ? 116 * std::cbrt(y) - 16 : 903.3 * y;
}

Picture cloud(Eigen::Index particles) {
  std::mt19937 generator(1);
  std::uniform_real_distribution<double> share(0, 1);
  Picture picture;
  picture.title = "Stage 2 - Cloud";
  picture.subtitle = "t = 1.234 s   dt = 2.0e-4 s   N = 5000";
  picture.upper = {800, 600};
  picture.length_unit = "px";
  picture.walls = {true, true, true, true};
  picture.radius = 8;
  picture.x = Eigen::ArrayXd::NullaryExpr(particles, [&] { return 800 * share(generator); });
  picture.y = Eigen::ArrayXd::NullaryExpr(particles, [&] { return 600 * share(generator); });
  picture.value = picture.x;
  picture.colours = {"|v|", "px/s", 0, 800, ColourMap::viridis};
  picture.note = "error of y: 1.2e-6 m (closed form)";
  return picture;
}

void paint(Canvas& canvas, const Picture& picture) { Painter().paint(canvas, picture, fit(picture, whole)); }

}  // namespace

TEST_CASE("a greater value is always lighter in viridis, so that the picture survives a grey projector",
          "[pictures]") {
  double before = -1;
  for (int k = 0; k <= 255; ++k) {
    const double now = lightness(at(ColourMap::viridis, k / 255.0));
    CHECK(now > before);
    before = now;
  }
}

TEST_CASE("viridis has its published colours, also between those that are stored", "[pictures]") {
  struct Published {
    int index;
    std::array<double, 3> colour;
  };
  const std::array published{
      Published{0, {0.267004, 0.004874, 0.329415}},   Published{2, {0.269944, 0.014625, 0.341379}},
      Published{102, {0.163625, 0.471133, 0.558148}}, Published{127, {0.128729, 0.563265, 0.551229}},
      Published{153, {0.134692, 0.658636, 0.517649}}, Published{204, {0.477504, 0.821444, 0.318195}},
      Published{243, {0.876168, 0.891125, 0.095250}}, Published{255, {0.993248, 0.906157, 0.143936}}};
  for (const auto& [index, colour] : published) {
    const Colour painted = at(ColourMap::viridis, index / 255.0);
    const double level = 1 / 255.0;  // of a pixel: what a screen can show
    CHECK(std::abs(double(painted.red) - colour[0]) < level);
    CHECK(std::abs(double(painted.green) - colour[1]) < level);
    CHECK(std::abs(double(painted.blue) - colour[2]) < level);
  }
}

TEST_CASE("in the map of signed values, what is as far from zero is as dark, and blue or red says the side",
          "[pictures]") {
  double before = lightness(at(ColourMap::cool_warm, 0.5));
  CHECK(before < 85);  // paper has 100: a particle at zero is seen on it
  for (int k = 1; k <= 64; ++k) {
    const Colour below = at(ColourMap::cool_warm, 0.5 - k / 128.0),
                 above = at(ColourMap::cool_warm, 0.5 + k / 128.0);
    CHECK(lightness(below) < before);
    CHECK(lightness(above) == Approx(lightness(below)).margin(1));
    CHECK(below.blue > below.red);
    CHECK(above.red > above.blue);
    before = lightness(below);
  }
}

TEST_CASE("who is blind to red or to green tells negative from positive in the map of signed values",
          "[pictures]") {
  // What remains of red, green, blue for them: Vienot, Brettel & Mollon 1999, on linear light. Both confuse
  // red with green, and see yellow against blue.
  const auto linear = [](float s) { return std::pow(double(s), 2.2); };
  struct Blindness {
    double red, green;  // their yellow, the same in both channels
  };
  for (const auto& [red, green] : {Blindness{0.11238, 0.88762}, Blindness{0.29275, 0.70725}}) {
    for (const double away : {0.125, 0.25, 0.5}) {
      const auto yellow_over_blue = [&](Colour c) {
        return std::log((red * linear(c.red) + green * linear(c.green)) / linear(c.blue));
      };
      CAPTURE(red, away);
      CHECK(yellow_over_blue(at(ColourMap::cool_warm, 0.5 - away)) < -0.2);
      CHECK(yellow_over_blue(at(ColourMap::cool_warm, 0.5 + away)) > 0.1);
    }
  }
}

TEST_CASE("small particles of a liquid leave no gaps between them, large ones are discs of their own size",
          "[pictures]") {
  Picture picture = cloud(2);
  picture.liquid = true;
  PictureView view = fit(picture, whole);
  RecordingCanvas canvas;
  const auto radius_at = [&](double pixels) {
    view.pixels_per_unit = pixels / picture.radius;
    canvas.disc_calls.clear();
    view.centre = {picture.x[0], picture.y[0]};
    Painter().paint(canvas, picture, view);
    return canvas.disc_calls.front().front().radius;
  };
  for (const double pixels : {1.5, 3.0, 4.5}) CHECK(radius_at(pixels) > 1.2 * pixels);
  CHECK(radius_at(20) == 20);
}

TEST_CASE("a value outside the legend has the colour of its end, a value that is no number is magenta",
          "[pictures]") {
  CHECK(at(ColourMap::viridis, -3) == at(ColourMap::viridis, 0));
  CHECK(at(ColourMap::viridis, std::numeric_limits<double>::infinity()) == at(ColourMap::viridis, 1));
  CHECK(at(ColourMap::viridis, nan) == not_a_number);
}

TEST_CASE("a legend is marked at three to five round values, whatever its range", "[pictures]") {
  std::mt19937 generator(2);
  std::uniform_real_distribution<double> share(0, 1), power(-12, 12);
  for (int k = 0; k < 2000; ++k) {
    const double lo = (2 * share(generator) - 1) * std::pow(10, power(generator) / 4);
    const double hi = lo + (0.01 + share(generator)) * std::abs(lo) * 10;
    const Ticks ticks = nice_ticks(lo, hi);
    CAPTURE(lo, hi, ticks.step);
    CHECK(ticks.count >= 3);
    CHECK(ticks.count <= 5);
    CHECK(ticks[0] >= lo - 1e-6 * ticks.step);
    CHECK(ticks[ticks.count - 1] <= hi + 1e-6 * ticks.step);
    const double leading = ticks.step / std::pow(10, std::floor(std::log10(ticks.step) + 1e-9));
    const std::array round{1.0, 2.0, 2.5, 5.0};
    CHECK(std::any_of(round.begin(), round.end(), [&](double r) { return std::abs(leading - r) < 1e-9; }));
  }
  CHECK(nice_ticks(1, 1).count == 0);
  CHECK(nice_ticks(0, nan).count == 0);
}

TEST_CASE("a tick is written with the decimals it needs and no more", "[pictures]") {
  CHECK(tick_label(200, 100) == "200");
  CHECK(tick_label(0.5, 0.5) == "0.5");
  CHECK(tick_label(0.25, 0.25) == "0.25");
  CHECK(tick_label(7.5, 2.5) == "7.5");
  CHECK(tick_label(1, 0.5) == "1.0");
  CHECK(tick_label(0, 0.5) == "0");
  CHECK(tick_label(-2000, 1000) == "-2000");
  CHECK(tick_label(2.5e-6, 5e-7) == "2.5e-6");
  CHECK(tick_label(1e-12, 1e-12) == "1e-12");
  CHECK(tick_label(250000, 50000) == "2.5e5");
}

TEST_CASE("a time step that changes at each step keeps its width on the screen", "[pictures]") {
  CHECK(three_digits(1.0e-3) == "1.00e-3");
  CHECK(three_digits(1.0471e-3) == "1.05e-3");
  CHECK(two_digits(0.0342) == "0.034");
  CHECK(two_digits(1.62) == "1.6");
  CHECK(two_digits(8) == "8.0");
  CHECK(two_digits(123.4) == "123");
}

TEST_CASE("the ruler's length is the greatest of 1, 2, 5 times a power of ten that fits", "[pictures]") {
  CHECK(nice_length(199) == Approx(100));
  CHECK(nice_length(200) == Approx(200));
  CHECK(nice_length(0.0061) == Approx(0.005));
}

TEST_CASE("the fitted view shows the whole domain, undistorted and centred", "[pictures]") {
  Picture picture = cloud(1);
  for (const Eigen::Array2d& extent :
       {Eigen::Array2d(800, 600), Eigen::Array2d(10, 0.1), Eigen::Array2d(0.1, 10)}) {
    picture.lower = {-3, 2};
    picture.upper = picture.lower + extent;
    const PictureView view = fit(picture, whole);
    const Point low = view.to_pixel(picture.lower.x(), picture.lower.y());
    const Point high = view.to_pixel(picture.upper.x(), picture.upper.y());
    CHECK((high.x - low.x) / (low.y - high.y) == Approx(extent.x() / extent.y()));
    CHECK(low.x > view.scene.corner.x);
    CHECK(high.y > view.scene.corner.y);
    CHECK(low.x - view.scene.corner.x == Approx(view.scene.corner.x + view.scene.extent.x - high.x));
    CHECK(high.y - view.scene.corner.y == Approx(view.scene.corner.y + view.scene.extent.y - low.y));
  }
}

TEST_CASE("the place under the mouse is the place in the world that was painted there", "[pictures]") {
  PictureView view = fit(cloud(1), whole, 1.5);
  view.centre = {17, -4};
  view.pixels_per_unit = 3.7;
  const Eigen::Vector2d world = view.to_world(view.to_pixel(120.5, -33.25));
  CHECK(world.x() == Approx(120.5));
  CHECK(world.y() == Approx(-33.25));
}

TEST_CASE("five thousand particles are one call of the canvas, with a rim as without", "[pictures]") {
  Picture picture = cloud(5000);
  picture.radius = GENERATE(2.0, 8.0);
  RecordingCanvas canvas;
  paint(canvas, picture);
  std::size_t calls = 0;
  for (const auto& call : canvas.disc_calls) calls += call.empty() ? 0 : 1;
  CHECK(calls == 1);
  CHECK(canvas.disc_calls.front().size() >= 5000);
}

TEST_CASE("a particle that has left for infinity is not painted, the others are", "[pictures]") {
  Picture picture = cloud(3);
  picture.radius = 1;
  picture.x[0] = nan;
  picture.y[1] = std::numeric_limits<double>::infinity();
  RecordingCanvas canvas;
  paint(canvas, picture);
  CHECK(canvas.disc_calls.front().size() == 1);
}

TEST_CASE("particles that all have one value have the colour that the legend marks with it", "[pictures]") {
  Picture picture = cloud(1);
  picture.value = 1000;
  picture.colours.lo = picture.colours.hi = 1000;
  RecordingCanvas canvas;
  paint(canvas, picture);
  CHECK(canvas.disc_calls.front().back().colour == at(ColourMap::viridis, 0.5));
  CHECK(
      std::any_of(canvas.texts.begin(), canvas.texts.end(), [](const auto& t) { return t.words == "1000"; }));
}

TEST_CASE(
    "no word but those of the reference stands over the scene, none beyond the sheet, on narrow pictures "
    "too",
    "[pictures]") {
  Picture picture = cloud(20);
  picture.title += std::string(GENERATE(0, 200), 'x');
  picture.ghosts = Ghosts{picture.x, picture.y, "closed form"};
  picture.chosen = Chosen{3, {4, 5}, 40, "particle 3: 2 neighbours"};
  const double width = GENERATE(600.0, 1280.0, 1920.0), scale = GENERATE(0.75, 1.0, 1.5);
  const PictureView view = fit(picture, {{0, 0}, {width, 720}}, scale);
  RecordingCanvas canvas({width, 720});
  Painter().paint(canvas, picture, view);
  CHECK(canvas.texts.size() >= 8);
  for (const auto& text : canvas.texts) {
    CAPTURE(text.words, width, scale);
    const double top = view.scene.corner.y, bottom = top + view.scene.extent.y;
    const bool of_reference =  // cut off at the end where there is no room
        text.words == "closed form" || text.words.starts_with("error of");
    CHECK((of_reference || text.at.y <= top || text.at.y - 0.75 * text.height >= bottom));  // capitals: 0.73
    CHECK(text.at.x >= 0);
    CHECK(text.at.x + text.width <= width);
  }
}

TEST_CASE("a chosen particle, its neighbours and ghosts are rings that leave the particle visible",
          "[pictures]") {
  Picture picture = cloud(20);
  picture.chosen = Chosen{3, {4, 5}, 40, ""};
  RecordingCanvas canvas;
  paint(canvas, picture);
  const auto& marks = canvas.disc_calls.at(1);
  CHECK(marks.size() == 4);
  CHECK(std::all_of(marks.begin(), marks.end(), [](const Disc& mark) { return mark.hole > 0; }));
}

TEST_CASE("the outline of an exact shape is one closed line, not a chain of particles", "[pictures]") {
  Picture picture = cloud(20);
  picture.ghosts = Ghosts{picture.x.head(5), picture.y.head(5), "exact", Shape::outline};
  RecordingCanvas canvas;
  paint(canvas, picture);
  for (std::size_t k = 1; k < canvas.disc_calls.size(); ++k) CHECK(canvas.disc_calls.at(k).empty());
  CHECK(std::ranges::any_of(
      canvas.lines, [](const auto& line) { return line.size() == 6 && line.front() == line.back(); }));
}

TEST_CASE("open lines of a reference are open, and begin again after a point that is no number",
          "[pictures]") {
  Picture picture = cloud(20);
  picture.x[3] = nan;
  picture.ghosts = Ghosts{picture.x.head(8), picture.y.head(8), "exact", Shape::lines};
  RecordingCanvas canvas;
  paint(canvas, picture);
  const PictureView view = fit(picture, whole);
  const auto painted = [&](Eigen::Index first, std::size_t points) {
    const Point begin = view.to_pixel(picture.ghosts->x[first], picture.ghosts->y[first]);
    return std::ranges::count_if(canvas.lines, [&](const auto& line) {
      return line.size() == points && line.front() == begin && !(line.back() == begin);
    });
  };
  CHECK(painted(0, 3) == 1);
  CHECK(painted(4, 4) == 1);
}

TEST_CASE("marks that are there now are labelled, and their labels do not cover each other", "[pictures]") {
  Picture picture = cloud(20);
  Eigen::ArrayXd x(4), y = Eigen::ArrayXd::Zero(4);
  x << 200, nan, 210, 700;
  picture.ghosts = Ghosts{x, y, "experiment", Shape::marks, {"one", "two", "three", "four"}};
  RecordingCanvas canvas;
  paint(canvas, picture);
  std::vector<double> heights;
  for (const auto& text : canvas.texts) {
    CHECK(text.words != "two");
    if (text.words != "one" && text.words != "three" && text.words != "four") continue;
    for (const double other : heights) CHECK(std::abs(other - text.at.y) >= text.height);
    heights.push_back(text.at.y);
  }
  CHECK(heights.size() == 3);
}

TEST_CASE("the error stands in a corner of the scene, on the side of the chosen particle", "[pictures]") {
  Picture picture = cloud(20);
  const PictureView view = fit(picture, whole);
  const double middle = view.scene.corner.x + view.scene.extent.x / 2;
  const auto corner = [&] {
    RecordingCanvas canvas;
    paint(canvas, picture);
    const auto note = std::ranges::find(canvas.texts, picture.note, &RecordingCanvas::Text::words);
    REQUIRE(note != canvas.texts.end());
    CHECK(note->at.y > view.scene.corner.y);
    CHECK(note->at.y < view.scene.corner.y + view.scene.extent.y / 4);
    return note->at.x < middle ? 'l' : 'r';
  };
  CHECK(corner() == 'l');
  picture.x[3] = 700;
  picture.chosen = Chosen{3, {}, 40, ""};
  CHECK(corner() == 'r');
  picture.x[3] = 100;
  CHECK(corner() == 'l');
}

TEST_CASE("a picture whose columns differ in length is refused", "[pictures]") {
  RecordingCanvas canvas;
  Picture picture = cloud(5);
  SECTION("y") { picture.y.resize(4); }
  SECTION("value") { picture.value.resize(6); }
  SECTION("chosen") { picture.chosen = Chosen{5, {}, 1, ""}; }
  SECTION("labels") { picture.ghosts = Ghosts{picture.x, picture.y, "", Shape::marks, {"one"}}; }
  SECTION("neighbours") { picture.chosen = Chosen{1, {-1}, 1, ""}; }
  CHECK_THROWS_AS(paint(canvas, picture), std::invalid_argument);
}

TEST_CASE("a comparison paints both pictures, one legend, and why a side stopped", "[pictures]") {
  Picture left = cloud(7), right = cloud(9);
  left.radius = right.radius = 1;
  left.legend = right.legend = false;
  right.alarm = "diverged at step 12";
  RecordingCanvas canvas;
  paint_sheet(canvas, left, Beside{"Stage 2", "t = 1 s", right});
  const auto said = [&](const std::string& words) {
    return std::ranges::count_if(canvas.texts, [&](const auto& text) { return text.words == words; });
  };
  CHECK(said("Stage 2") == 1);
  CHECK(said("diverged at step 12") == 1);
  CHECK(said("|v| [px/s]") == 1);
  CHECK(canvas.disc_calls.at(0).size() == 7);
  CHECK(canvas.disc_calls.at(2).size() == 9);
  for (const Disc& disc : canvas.disc_calls.at(0)) CHECK(disc.centre.x < 640);
  for (const Disc& disc : canvas.disc_calls.at(2)) CHECK(disc.centre.x > 640);
}

}  // namespace clapotis
