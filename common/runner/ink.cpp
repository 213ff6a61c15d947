#include "common/runner/ink.hpp"

#include <algorithm>
#include <string>

namespace clapotis::ink {
namespace {

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
