// Whether both palettes can be read from the back row, by the contrast of the W3C's guidelines (WCAG 2.1,
// 2018).

#include "common/runner/ink.hpp"

#include <algorithm>
#include <cmath>

#include "common/runner/colour_map.hpp"
#include "tests/catch.hpp"

using namespace clapotis;

namespace {

/// Relative luminance of an sRGB colour, WCAG 2.1.
double luminance(Colour c) {
  const auto linear = [](float part) {
    const double s = static_cast<double>(part);
    return s <= 0.03928 ? s / 12.92 : std::pow((s + 0.055) / 1.055, 2.4);
  };
  return 0.2126 * linear(c.red) + 0.7152 * linear(c.green) + 0.0722 * linear(c.blue);
}

double contrast(Colour a, Colour b) {
  const auto [low, high] = std::minmax({luminance(a), luminance(b)});
  return (high + 0.05) / (low + 0.05);
}

/// Chooses a theme until the end of the test.
struct Wearing {
  explicit Wearing(ink::Theme theme) { ink::use(theme); }
  ~Wearing() { ink::use(ink::Theme::light); }
};

}  // namespace

TEST_CASE("texts, curves and particles of both themes stand out from what is behind them", "[pictures]") {
  for (const auto theme : {ink::Theme::light, ink::Theme::dark}) {
    const Wearing it(theme);
    const auto& p = ink::palette();
    INFO("theme " << ink::theme_names[static_cast<std::size_t>(theme)]);
    for (const auto& behind : {p.sheet, p.paper, p.panel, p.field}) {
      CHECK(contrast(p.text, behind) > 7);          // level AAA for texts
      CHECK(contrast(p.faint_text, behind) > 4.5);  // level AA
    }
    for (const auto& said : {p.caution, p.warning}) CHECK(contrast(said, p.panel) > 4.5);
    CHECK(contrast({1, 1, 1}, p.accent) > 3);  // the letters of the main button, which are large
    for (const auto& drawn : {p.ghost, p.wall, p.plain_disc}) CHECK(contrast(drawn, p.paper) > 3);
    for (const auto& curve : p.curves) CHECK(contrast(curve, p.paper) > 2.2);  // orange on white is the least
    double least = 100;
    for (int k = 0; k <= 100; ++k)
      for (const auto map : {ColourMap::viridis, ColourMap::cool_warm})
        least = std::min(least, contrast(at(map, k / 100.0), p.paper));
    CHECK(least > (theme == ink::Theme::light ? 1.2 : 2));  // yellow on white has a rim
  }
}

TEST_CASE("an ink is a colour of the theme in use", "[pictures]") {
  const Colour before = ink::paper;
  const Wearing dark(ink::Theme::dark);
  CHECK(luminance(before) > 0.9);
  CHECK(luminance(ink::paper) < 0.01);
  CHECK(luminance(ink::text) > 0.8);
}
