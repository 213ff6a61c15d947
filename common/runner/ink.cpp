#include "common/runner/ink.hpp"

#include <algorithm>
#include <string>

namespace clapotis::ink {
namespace {

constexpr Palette light{.sheet{0.957F, 0.965F, 0.973F},
                        .paper{1.0F, 1.0F, 1.0F},
                        .text{0.11F, 0.14F, 0.18F},
                        .faint_text{0.33F, 0.37F, 0.42F},
                        .wall{0.20F, 0.24F, 0.29F},
                        .grid{0.78F, 0.80F, 0.83F},
                        .plain_disc{0.16F, 0.42F, 0.69F},
                        .ghost{0.80F, 0.20F, 0.10F},
                        .chosen{0.90F, 0.45F, 0.00F},
                        .in_vain{0.99F, 0.80F, 0.58F},
                        .visited{0.99F, 0.80F, 0.58F, 0.5F},
                        .curves{{{0.000F, 0.447F, 0.698F},    // blue
                                 {0.835F, 0.369F, 0.000F},    // vermilion
                                 {0.000F, 0.620F, 0.451F},    // bluish green
                                 {0.800F, 0.475F, 0.655F},    // reddish purple
                                 {0.902F, 0.624F, 0.000F},    // orange
                                 {0.110F, 0.140F, 0.180F}}},  // near black
                        .spare{{{0.337F, 0.706F, 0.914F},     // sky blue
                                {0.941F, 0.894F, 0.259F},     // yellow
                                {0.450F, 0.490F, 0.540F}}},   // grey
                        .darkest = 0,
                        .panel{0.945F, 0.950F, 0.955F},
                        .field{1.0F, 1.0F, 1.0F},
                        .button{0.875F, 0.895F, 0.915F},
                        .accent{0.10F, 0.37F, 0.60F},
                        .caution{0.60F, 0.36F, 0.00F},
                        .warning{0.72F, 0.20F, 0.08F}};

/// Its curves are those of the light palette, lightened: 5 : 1 against the paper at least.
constexpr Palette dark{.sheet{0.105F, 0.118F, 0.137F},
                       .paper{0.055F, 0.063F, 0.075F},
                       .text{0.930F, 0.940F, 0.955F},
                       .faint_text{0.700F, 0.730F, 0.770F},
                       .wall{0.620F, 0.655F, 0.700F},
                       .grid{0.290F, 0.315F, 0.350F},
                       .plain_disc{0.345F, 0.640F, 0.930F},
                       .ghost{1.000F, 0.450F, 0.330F},
                       .chosen{1.000F, 0.620F, 0.150F},
                       .in_vain{0.480F, 0.340F, 0.180F},
                       .visited{0.480F, 0.340F, 0.180F, 0.5F},
                       .curves{{{0.337F, 0.706F, 0.914F},    // sky blue
                                {0.960F, 0.480F, 0.160F},    // vermilion
                                {0.180F, 0.760F, 0.580F},    // bluish green
                                {0.870F, 0.600F, 0.760F},    // reddish purple
                                {0.941F, 0.894F, 0.259F},    // yellow
                                {0.930F, 0.940F, 0.955F}}},  // near white
                       .spare{{{0.560F, 0.600F, 0.980F},     // blue
                               {0.902F, 0.624F, 0.000F},     // orange
                               {0.620F, 0.655F, 0.700F}}},   // grey
                       .darkest = 0.25F,
                       .panel{0.150F, 0.165F, 0.188F},
                       .field{0.090F, 0.100F, 0.118F},
                       .button{0.240F, 0.265F, 0.300F},
                       .accent{0.180F, 0.480F, 0.760F},
                       .caution{0.960F, 0.690F, 0.230F},
                       .warning{1.000F, 0.480F, 0.360F}};

Theme in_use = Theme::light;

constexpr double smallest = 0.6;

bool continues_a_letter(char byte) { return (static_cast<unsigned char>(byte) & 0xC0U) == 0x80U; }

std::string cut(const Canvas& canvas, std::string_view utf8, double height, double room) {
  std::string kept(utf8);
  while (!kept.empty() && canvas.text_width(kept + "…", height) > room) {
    while (continues_a_letter(kept.back()) && kept.size() > 1) kept.pop_back();
    kept.pop_back();
  }
  return kept.empty() ? kept : kept + "…";
}

}  // namespace

const Palette& palette() { return in_use == Theme::dark ? dark : light; }
Theme theme() { return in_use; }
void use(Theme theme) { in_use = theme; }

void paper_box(Canvas& canvas, const Box& box, Colour rim, double width) {
  canvas.rectangle(
      {{box.corner.x - width, box.corner.y - width}, {box.extent.x + 2 * width, box.extent.y + 2 * width}},
      rim);
  canvas.rectangle(box, paper);
}

void fitted_text(Canvas& canvas, Point at, std::string_view utf8, double height, double room, Colour colour,
                 Align align) {
  if (utf8.empty() || room <= 0) return;
  const double width = canvas.text_width(utf8, height);
  if (width <= room) return canvas.text(at, utf8, height, colour, align);
  const double shrunk = height * std::max(smallest, room / width);
  if (room / width >= smallest) return canvas.text(at, utf8, shrunk, colour, align);
  canvas.text(at, cut(canvas, utf8, shrunk, room), shrunk, colour, align);
}

std::vector<std::string> broken(const Canvas& canvas, std::string_view utf8, double height, double room) {
  std::vector<std::string> lines;
  std::string line;
  while (!utf8.empty()) {
    const auto end = std::min(utf8.find(' ', 1), utf8.size());
    const auto longer = line + std::string(utf8.substr(0, end));
    if (!line.empty() && canvas.text_width(longer, height) > room) {
      lines.push_back(line);
      line = utf8.substr(1, end - 1);
    } else {
      line = longer;
    }
    utf8.remove_prefix(end);
  }
  lines.push_back(line);
  return lines;
}

}  // namespace clapotis::ink
