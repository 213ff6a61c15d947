#include <algorithm>
#include <cmath>
#include <limits>

#include "common/runner/plot.hpp"
#include "common/runner/plot_axes.hpp"
#include "tests/catch.hpp"
#include "tests/common/recording_canvas.hpp"

namespace clapotis {
namespace {

constexpr double nan = std::numeric_limits<double>::quiet_NaN();
constexpr Box strip{{0, 500}, {1280, 220}};

Plot plot_of(std::vector<double> ys, bool log_y = false) {
  std::vector<double> xs(ys.size());
  for (std::size_t k = 0; k < xs.size(); ++k) xs[k] = double(k);
  return {"Energies",
          "t [s]",
          "E [J]",
          {{"total", ink::palette().curves[0], std::move(xs), std::move(ys), false}},
          log_y};
}

/// The polylines of the curves; the axes are painted before them, as one line of three points.
std::vector<std::vector<Point>> curves_of(const RecordingCanvas& canvas) {
  const auto axes =
      std::find_if(canvas.lines.begin(), canvas.lines.end(), [](const auto& l) { return l.size() == 3; });
  REQUIRE(axes != canvas.lines.end());
  return {axes + 1, canvas.lines.end()};
}

bool has_text(const RecordingCanvas& canvas, const std::string& words) {
  return std::any_of(canvas.texts.begin(), canvas.texts.end(),
                     [&](const auto& t) { return t.words == words; });
}

}  // namespace

TEST_CASE("one outlier among a million points is still seen", "[plots]") {
  std::vector<double> energy(1'000'000, 1.0);
  energy[654'321] = 5;
  RecordingCanvas canvas;
  paint(canvas, plot_of(energy), strip);
  const auto curves = curves_of(canvas);
  REQUIRE(curves.size() == 1);
  CHECK(curves[0].size() <= 4 * 1280);  // four per pixel column
  const auto higher = [](Point a, Point b) { return a.y < b.y; };
  const Point peak = *std::min_element(curves[0].begin(), curves[0].end(), higher);
  const Point start = curves[0].front(), end = curves[0].back();
  CHECK(peak.y < start.y - 50);
  CHECK((peak.x - start.x) / (end.x - start.x) == Approx(0.654321).margin(1e-5));
}

TEST_CASE("a logarithmic error has a gap where it is zero or no number", "[plots]") {
  RecordingCanvas canvas;
  paint(canvas, plot_of({0, 1e-6, 2e-6, 0, 3e-6, 4e-6, nan, 5e-6}, true), strip);
  const auto curves = curves_of(canvas);
  REQUIRE(curves.size() == 2);
  for (const auto& curve : curves) {
    for (const Point p : curve) CHECK((std::isfinite(p.x) && std::isfinite(p.y)));
  }
  const bool lone_point_is_a_dot = canvas.disc_calls.size() == 1;
  CHECK(lone_point_is_a_dot);
  CHECK(has_text(canvas, "1e-6"));
  CHECK(has_text(canvas, "1e-5"));
}

TEST_CASE("a plot without a single number has axes and no curve", "[plots]") {
  RecordingCanvas canvas;
  const bool log_y = GENERATE(false, true);
  const auto ys = GENERATE(std::vector<double>{}, std::vector<double>{nan}, std::vector<double>{nan, nan});
  paint(canvas, plot_of(ys, log_y), strip);
  CHECK(curves_of(canvas).empty());
  CHECK(canvas.disc_calls.empty());
}

TEST_CASE("an energy that is constant up to rounding is painted level", "[plots]") {
  RecordingCanvas canvas;
  std::vector<double> energy(100, 70);
  energy[50] = std::nextafter(70.0, 71.0);
  paint(canvas, plot_of(energy), strip);
  const auto curves = curves_of(canvas);
  for (const Point p : curves.at(0)) CHECK(p.y == Approx(curves[0][0].y).margin(1e-6));
}

TEST_CASE("a greater energy stands higher, a later one further right", "[plots]") {
  RecordingCanvas canvas;
  paint(canvas, plot_of({1, 2, 3}), strip);
  const auto curve = curves_of(canvas).at(0);
  REQUIRE(curve.size() == 3);
  CHECK(curve[0].y > curve[1].y);
  CHECK(curve[1].y > curve[2].y);
  CHECK(curve[0].x < curve[1].x);
}

TEST_CASE("a dashed curve is painted on about three fifths of its length", "[plots]") {
  Plot plot = plot_of(std::vector<double>(1000, 1.0));
  plot.curves[0].dashed = true;
  RecordingCanvas canvas;
  paint(canvas, plot, strip);
  double painted = 0, start = 1e9, end = 0;
  const auto pieces = curves_of(canvas);
  for (const auto& piece : pieces) {
    painted += piece.back().x - piece.front().x;
    start = std::min(start, piece.front().x);
    end = std::max(end, piece.back().x);
  }
  CHECK(painted / (end - start) == Approx(0.6).margin(0.02));  // 12 of 20 pixels; the last dash may be cut
}

TEST_CASE("all words of a plot are on it", "[plots]") {
  RecordingCanvas canvas;
  paint(canvas, plot_of({1, 2, 3}), {{0, 500}, {GENERATE(320.0, 640.0, 1280.0), 220}});
  for (const char* words : {"Energies", "t [s]", "E [J]", "total"}) CHECK(has_text(canvas, words));
}

TEST_CASE("a curve with more times than energies is refused by its name", "[plots]") {
  RecordingCanvas canvas;
  Plot plot = plot_of({1, 2, 3});
  plot.curves[0].xs.push_back(4);
  CHECK_THROWS_WITH(paint(canvas, plot, strip), "curve \"total\" needs as many ys as xs");
}

TEST_CASE("a logarithmic axis reaches down to the lowest of two errors", "[pictures]") {
  Plot plot;
  plot.log_y = true;
  plot.curves.resize(2);
  plot.curves[0].xs = plot.curves[1].xs = {0, 1};
  plot.curves[0].ys = {1e-16, 2e-4};
  plot.curves[1].ys = {1e-18, 2e-12};
  CHECK(ranges_of(plot).y.lo == -17);
  CHECK(ranges_of(plot).y.hi == -3);
  plot.curves.pop_back();
  CHECK(ranges_of(plot).y.lo == -9);  // its beginning at rounding does not press its course into a line
}

}  // namespace clapotis
